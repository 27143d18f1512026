// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/critical_speeds.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "postprocess/tables/table.h"
#include "postprocess/waves/travelling_spectrum.h"

namespace tiprub::postprocess {

namespace {

constexpr double large_wave = 0.2;  // of the largest one's amplitude
constexpr std::size_t most_others = 4;

struct PeakWave {
  double engine_order;
  int signed_nodal_diameter;
  double amplitude;  // [m] at the peak
  double rise;       // [m] above the higher of its values at the two valleys
};

/// All waves above frequency zero, those with the largest amplitude first.
std::vector<PeakWave> waves_of(const TravellingSpectrum& here, const TravellingSpectrum& left,
                               const TravellingSpectrum& right) {
  std::vector<PeakWave> waves;
  for (int line = 1; line < here.lines(); ++line)
    for (int column = 0; column < here.sector_count; ++column) {
      const double order = here.engine_order(line), amplitude = here.amplitude(line, column);
      const int n = signed_nodal_diameter(column, here.sector_count);
      waves.push_back({order, n, amplitude, amplitude - std::max(left.at(order, n), right.at(order, n))});
    }
  std::ranges::stable_sort(waves, std::greater(), &PeakWave::amplitude);
  return waves;
}

/// Names the waves of a peak, at the node that moves most.
void name_waves(CriticalSpeed& critical, const Peak& peak, const Response& response, const ContactLine& contact,
                const FrequencyCurves& curves, Component component) {
  const auto spectrum = [&](Eigen::Index index) {
    const SpeedResponse& speed = response.speeds[static_cast<std::size_t>(index)];
    return travelling_spectrum(tip_motion(speed, response.scene, contact, critical.node, component),
                               speed.recorded_revolutions);
  };
  const std::vector<PeakWave> waves =
      waves_of(spectrum(peak.index), spectrum(peak.left_valley), spectrum(peak.right_valley));
  if (waves.empty()) return;
  const auto label = [&](const PeakWave& wave) {
    return label_wave(curves, response.scene.sector_count, critical.speed, wave.engine_order,
                      wave.signed_nodal_diameter, wave.amplitude);
  };
  const auto rising = std::ranges::max_element(waves, {}, &PeakWave::rise);
  critical.rising = label(*rising);
  critical.largest = label(waves.front());
  for (auto wave = waves.begin(); wave != waves.end() && critical.others.size() < most_others; ++wave) {
    if (wave->amplitude < large_wave * waves.front().amplitude) break;
    if (wave != rising) critical.others.push_back(label(*wave));
  }
}

constexpr double even_top = 0.02;       // of a peak's amplitude: tops that are that close can't be told apart
constexpr double most_of_range = 0.65;  // an interval that spans it locates nothing

/// A response over speed.
struct Samples {
  Eigen::VectorXd speed;             ///< [rad/s]
  const Eigen::VectorXd& amplitude;  ///< [m]
  Eigen::VectorXd step_change;       ///< [1] by the last halving of the step

  Eigen::Index last() const { return speed.size() - 1; }
};

/// The nearest sample in direction `step` at which the response is below `least`, or the last one.
Eigen::Index foot(const Samples& samples, Eigen::Index place, int step, double least) {
  Eigen::Index i = place + step;
  while (i > 0 && i < samples.last() && samples.amplitude[i] >= least) i += step;
  return i;
}

/// [m] The largest amplitude that is possible between a peak's sample and its neighbours: after the rise that the
/// flanks allow, or of a resonance with the mode's damping whose top is midway between two samples.
double highest_between(const Samples& samples, const CriticalSpeed& critical) {
  const auto rise = [&](int step) { return rise_beside(samples.speed, samples.amplitude, critical.index, step); };
  const double half_gap = critical.spacing_over_half_width().value_or(0) / 2;
  return std::max(critical.amplitude + std::max(rise(-1), rise(+1)), critical.amplitude * std::hypot(1.0, half_gap));
}

void locate(CriticalSpeed& critical, const Samples& samples) {
  const auto& [speed, amplitude, step_change] = samples;
  const Eigen::Index place = critical.index;
  const double least = (1 - even_top - step_change[place]) * critical.amplitude;
  const Eigen::Index low = foot(samples, place, -1, least), high = foot(samples, place, +1, least);
  critical.speed_low = speed[low];
  critical.speed_high = speed[high];
  critical.spacing = std::max(speed[place] - speed[place - 1], speed[place + 1] - speed[place]);
  const double step_error = step_change.segment(low + 1, high - low - 1).maxCoeff() * critical.amplitude;
  critical.amplitude_low = critical.amplitude - step_error;
  critical.amplitude_high = highest_between(samples, critical) + step_error;
  critical.located = std::max(amplitude[low], amplitude[high]) < least &&
                     amplitude.segment(low, high - low + 1).maxCoeff() <= critical.amplitude &&
                     speed[high] - speed[low] < most_of_range * (speed[samples.last()] - speed[0]);
}

Samples samples_of(const Response& response, const Eigen::VectorXd& amplitude) {
  Samples samples{Eigen::VectorXd(amplitude.size()), amplitude, Eigen::VectorXd(amplitude.size())};
  for (Eigen::Index i = 0; i < amplitude.size(); ++i) {
    const SpeedResponse& speed = response.speeds[static_cast<std::size_t>(i)];
    samples.speed[i] = speed.speed;
    samples.step_change[i] = speed.audit.halving_difference.value_or(0);
  }
  return samples;
}

void largest_first(std::vector<WaveLabel>& waves) {
  std::ranges::stable_sort(waves, std::greater(), &WaveLabel::amplitude);
}

/// "EO 10 ND 0 48 %"
std::string with_share(const WaveLabel& wave, const CriticalSpeed& critical) {
  return wave_name(wave) + " " + fixed(percent * wave.amplitude / critical.amplitude, 0) + " %";
}

}  // namespace

std::optional<double> CriticalSpeed::spacing_over_half_width() const {
  std::optional<double> narrowest = rising.half_width;
  if (!narrowest) return std::nullopt;
  for (const WaveLabel& wave : others) narrowest = std::min(*narrowest, wave.half_width.value_or(*narrowest));
  if (!(*narrowest > 0)) return std::nullopt;  // without damping
  return spacing / *narrowest;
}

double CriticalSpeed::amplitude_slack() const {
  return amplitude > 0 ? std::max(amplitude_high - amplitude, amplitude - amplitude_low) / amplitude : 0;
}

std::vector<WaveLabel> CriticalSpeed::waves_beside() const {
  std::vector<WaveLabel> waves = {rising};
  waves.insert(waves.end(), others.begin(), others.end());
  std::erase_if(waves, [&](const WaveLabel& wave) { return wave_name(wave) == wave_name(naming_wave()); });
  largest_first(waves);
  return waves;
}

std::string wave_names(const CriticalSpeed& critical) {
  if (!critical.is_mixed()) return wave_name(critical.naming_wave());
  constexpr std::size_t named = 2;  // beside the wave that makes the peak
  std::vector<WaveLabel> waves = {critical.rising};
  waves.insert(waves.end(), critical.others.begin(),
               critical.others.begin() + static_cast<std::ptrdiff_t>(std::min(named, critical.others.size())));
  largest_first(waves);
  return "mixed: " + listed(waves, ", ", [&](const WaveLabel& wave) { return with_share(wave, critical); });
}

Eigen::Index TipAmplitudes::worst() const {
  Eigen::Index worst = 0;
  largest.maxCoeff(&worst);
  return worst;
}

TipAmplitudes tip_amplitudes(const Response& response, const ContactLine& contact, Component component) {
  const auto speeds = static_cast<Eigen::Index>(response.speeds.size());
  TipAmplitudes amplitudes{Eigen::MatrixXd(contact.size(), speeds), Eigen::VectorXd(speeds), Eigen::VectorXi(speeds),
                           contact.trailing_edge()};
  for (Eigen::Index i = 0; i < speeds; ++i) {
    const SpeedResponse& speed = response.speeds[static_cast<std::size_t>(i)];
    for (int node = 0; node < contact.size(); ++node)
      amplitudes.by_node(node, i) = vibration_amplitude(tip_motion(speed, response.scene, contact, node, component));
    Eigen::Index where = 0;
    amplitudes.largest[i] = amplitudes.by_node.col(i).maxCoeff(&where);
    amplitudes.node[i] = static_cast<int>(where);
  }
  return amplitudes;
}

std::vector<CriticalSpeed> critical_speeds(const Response& response, const ContactLine& contact,
                                           const TipAmplitudes& amplitudes, const FrequencyCurves& curves,
                                           const PostprocessParameters& parameters) {
  std::vector<CriticalSpeed> all;
  const Samples samples = samples_of(response, amplitudes.largest);
  for (const Peak& peak : named_peaks(amplitudes.largest, {.prominence = parameters.prominence})) {
    const SpeedResponse& peak_response = response.speeds[static_cast<std::size_t>(peak.index)];
    CriticalSpeed critical;
    critical.index = peak.index;
    critical.speed = peak_response.speed;
    critical.amplitude = amplitudes.largest[peak.index];
    critical.prominence = peak.prominence;
    critical.node = amplitudes.node[peak.index];
    name_waves(critical, peak, response, contact, curves, parameters.component);
    locate(critical, samples);
    all.push_back(critical);
  }
  return all;
}

std::optional<std::size_t> largest_critical(const std::vector<CriticalSpeed>& critical) {
  const auto largest = std::ranges::max_element(critical, {}, &CriticalSpeed::amplitude);
  if (largest == critical.end()) return std::nullopt;
  return static_cast<std::size_t>(largest - critical.begin());
}

OperatingMargin operating_margin(const std::vector<CriticalSpeed>& critical, const SpeedRange& operating) {
  OperatingMargin margin;
  for (const CriticalSpeed& peak : critical) {
    if (peak.speed_high < operating.low)
      margin.below = {peak.speed, (operating.low - peak.speed_high) / operating.low};
    else if (peak.speed_low <= operating.high)
      margin.inside.push_back(peak);
    else if (!margin.above)
      margin.above = {peak.speed, (peak.speed_low - operating.high) / operating.high};
  }
  return margin;
}

}  // namespace tiprub::postprocess
