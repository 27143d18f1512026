// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/critical_speeds.h"

#include <algorithm>

#include "postprocess/waves/travelling_spectrum.h"

namespace tiprub {

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
  std::stable_sort(waves.begin(), waves.end(),
                   [](const PeakWave& a, const PeakWave& b) { return a.amplitude > b.amplitude; });
  return waves;
}

/// Reads the waves of a peak at the node that moves most.
class PeakReader {
 public:
  PeakReader(const Response& response, const ContactLine& contact, const FrequencyCurves& curves, Component component)
      : response_(response), contact_(contact), curves_(curves), component_(component) {}

  void name_waves(CriticalSpeed& critical, const Peak& peak) const {
    const auto spectrum = [&](Eigen::Index speed) {
      const SpeedResponse& response = response_.speeds[static_cast<std::size_t>(speed)];
      return travelling_spectrum(tip_motion(response, response_.scene, contact_, critical.node, component_),
                                 response.recorded_revolutions);
    };
    const std::vector<PeakWave> waves =
        waves_of(spectrum(peak.index), spectrum(peak.left_valley), spectrum(peak.right_valley));
    if (waves.empty()) return;
    const auto label = [&](const PeakWave& wave) {
      return label_wave(curves_, response_.scene.sector_count, critical.speed, wave.engine_order,
                        wave.signed_nodal_diameter, wave.amplitude);
    };
    const auto rising = std::max_element(waves.begin(), waves.end(),
                                         [](const PeakWave& a, const PeakWave& b) { return a.rise < b.rise; });
    critical.rising = label(*rising);
    for (auto wave = waves.begin(); wave != waves.end() && critical.others.size() < most_others; ++wave) {
      if (wave->amplitude < large_wave * waves.front().amplitude) break;
      if (wave != rising) critical.others.push_back(label(*wave));
    }
  }

 private:
  const Response& response_;
  const ContactLine& contact_;
  const FrequencyCurves& curves_;
  Component component_;
};

/// [1] of a peak's amplitude: tops that differ by less can't be told apart.
constexpr double even_top = 0.02;

/// [rad/s] Where the response, from sample `place` in direction `step`, falls to `least`: between the last sample
/// that is at least as large and the next one.
double foot(const Response& response, const Eigen::VectorXd& amplitudes, Eigen::Index place, int step, double least) {
  Eigen::Index i = place + step;
  while (i > 0 && i + 1 < amplitudes.size() && amplitudes[i] >= least) i += step;
  const double below = response.speeds[static_cast<std::size_t>(i)].speed;
  const double above = response.speeds[static_cast<std::size_t>(i - step)].speed;
  if (amplitudes[i] >= least) return below;
  return above + (below - above) * (amplitudes[i - step] - least) / (amplitudes[i - step] - amplitudes[i]);
}

void locate(CriticalSpeed& critical, const Response& response, const Eigen::VectorXd& amplitudes) {
  const auto place = static_cast<std::size_t>(critical.index);
  const std::vector<SpeedResponse>& speeds = response.speeds;
  const double step_error = speeds[place].audit.halving_difference.value_or(0) * critical.amplitude;
  const double least = (1 - even_top) * critical.amplitude - step_error;
  critical.speed_low = foot(response, amplitudes, critical.index, -1, least);
  critical.speed_high = foot(response, amplitudes, critical.index, +1, least);
  const ParabolaTop top =
      parabola_top({speeds[place - 1].speed, critical.speed, speeds[place + 1].speed},
                   {amplitudes[critical.index - 1], critical.amplitude, amplitudes[critical.index + 1]});
  critical.amplitude_low = critical.amplitude - step_error;
  critical.amplitude_high = critical.amplitude + std::max(step_error, top.height);
}

}  // namespace

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
  const PeakReader reader(response, contact, curves, parameters.component);
  std::vector<CriticalSpeed> all;
  for (const Peak& peak : find_peaks(amplitudes.largest, parameters.prominence)) {
    const SpeedResponse& peak_response = response.speeds[static_cast<std::size_t>(peak.index)];
    CriticalSpeed critical;
    critical.index = peak.index;
    critical.speed = peak_response.speed;
    critical.amplitude = amplitudes.largest[peak.index];
    critical.prominence = peak.prominence;
    critical.node = amplitudes.node[peak.index];
    critical.motion = peak_response.motion;
    critical.period_beats = peak_response.period_beats;
    locate(critical, response, amplitudes.largest);
    reader.name_waves(critical, peak);
    all.push_back(critical);
  }
  return all;
}

std::optional<std::size_t> worst_critical(const std::vector<CriticalSpeed>& critical) {
  const auto worst =
      std::max_element(critical.begin(), critical.end(),
                       [](const CriticalSpeed& a, const CriticalSpeed& b) { return a.amplitude < b.amplitude; });
  if (worst == critical.end()) return std::nullopt;
  return static_cast<std::size_t>(worst - critical.begin());
}

OperatingMargin operating_margin(const std::vector<CriticalSpeed>& critical, const SpeedRange& operating,
                                 double smallest_amplitude) {
  OperatingMargin margin;
  for (const CriticalSpeed& peak : critical) {  // ascending in speed
    if (peak.amplitude < smallest_amplitude) continue;
    if (peak.speed < operating.low)
      margin.below = {peak.speed, (operating.low - peak.speed) / operating.low};
    else if (peak.speed <= operating.high)
      margin.inside.push_back(peak.speed);
    else if (!margin.above)
      margin.above = {peak.speed, (peak.speed - operating.high) / operating.high};
  }
  return margin;
}

}  // namespace tiprub
