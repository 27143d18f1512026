// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/linear_rules.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

constexpr int root_intervals = 400;
constexpr int bisections = 60;

double bisect(const std::function<double(double)>& function, double low, double high) {
  const bool rising = function(low) < 0;
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    ((function(middle) < 0) == rising ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void append_crossings(std::vector<Crossing>& crossings, const FrequencyCurves& curves,
                      const std::vector<int>& families, int engine_order, int signed_nodal_diameter,
                      const SpeedRange& range) {
  const int nodal_diameter = std::abs(signed_nodal_diameter);
  for (const int family : families) {
    if (family >= curves.families(nodal_diameter)) continue;
    const auto frequency = [&](double speed) { return curves.frequency(nodal_diameter, family, speed); };
    for (const double speed : criterion_speeds(frequency, engine_order, 0.0, range))
      crossings.push_back({speed, frequency(speed), engine_order, signed_nodal_diameter, family, 0.0});
  }
}

constexpr double same_order = 1e-9;
constexpr double moving_wave = 0.1;  // of the largest amplitude of all

/// Every travelling wave of a response at the contact node where it is the largest; one spectrum per speed.
std::vector<TravellingSpectrum> largest_waves(const Response& response, const ContactLine& contact,
                                              Component component) {
  std::vector<TravellingSpectrum> waves;
  for (const SpeedResponse& speed : response.speeds) {
    const auto spectrum = [&](int node) {
      return travelling_spectrum(tip_motion(speed, response.scene, contact, node, component),
                                 speed.recorded_revolutions);
    };
    TravellingSpectrum largest = spectrum(0);
    for (int node = 1; node < contact.size(); ++node)
      largest.amplitude = largest.amplitude.cwiseMax(spectrum(node).amplitude);
    waves.push_back(std::move(largest));
  }
  return waves;
}

MovingWaves moving_waves(const Response& response, const std::vector<TravellingSpectrum>& waves,
                         const FrequencyCurves& curves, const std::vector<CriticalSpeed>& critical,
                         double largest_amplitude) {
  std::set<int> families, engine_orders;
  const auto enter = [&](int engine_order, int family) {
    engine_orders.insert(engine_order);
    families.insert(family);
  };
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const TravellingSpectrum& here = waves[i];
    const double speed = response.speeds[i].speed;
    for (int order = 1; order * here.revolutions < here.lines(); ++order)
      for (int column = 0; column < here.sector_count; ++column)
        if (here.amplitude(order * here.revolutions, column) > moving_wave * largest_amplitude)
          enter(order, curves.nearest_family(aliased_nodal_diameter(column, here.sector_count),
                                             order * speed * hz_per_rad_s, speed));
  }
  for (const CriticalSpeed& peak : critical)
    if (const double order = std::round(peak.naming_wave().engine_order);
        std::abs(order - peak.naming_wave().engine_order) < same_order)
      enter(static_cast<int>(order), peak.naming_wave().family);
  return {{families.begin(), families.end()}, {engine_orders.begin(), engine_orders.end()}};
}

/// Gives each crossing the amplitude of its wave at its speed, linear between neighbouring speeds.
void read_amplitudes(std::vector<Crossing>& crossings, const Response& response,
                     const std::vector<TravellingSpectrum>& waves) {
  const auto& speeds = response.speeds;
  for (Crossing& crossing : crossings) {
    const auto above = std::ranges::lower_bound(speeds, crossing.speed, {}, &SpeedResponse::speed);
    const auto high = std::min(static_cast<std::size_t>(above - speeds.begin()), speeds.size() - 1);
    const std::size_t low = high > 0 ? high - 1 : 0;
    const double span = speeds[high].speed - speeds[low].speed;
    const double part = span > 0 ? std::clamp((crossing.speed - speeds[low].speed) / span, 0.0, 1.0) : 0.0;
    const auto amplitude = [&](std::size_t i) {
      return waves[i].at(crossing.engine_order, crossing.signed_nodal_diameter);
    };
    crossing.amplitude = (1 - part) * amplitude(low) + part * amplitude(high);
  }
}

}  // namespace

std::vector<double> criterion_speeds(const std::function<double(double)>& frequency, int engine_order,
                                     double casing_frequency, const SpeedRange& range) {
  const auto mismatch = [&](double speed) {
    return frequency(speed) - std::abs(engine_order * speed * hz_per_rad_s - casing_frequency);  // eq. 2
  };
  std::vector<double> roots;
  double low = range.low, at_low = mismatch(low);
  if (at_low == 0) roots.push_back(low);
  for (int i = 1; i <= root_intervals && range.high > range.low; ++i) {
    const double high = range.low + (range.high - range.low) * i / root_intervals;
    const double at_high = mismatch(high);
    if (at_high == 0)
      roots.push_back(high);
    else if (at_low * at_high < 0)
      roots.push_back(bisect(mismatch, low, high));
    low = high;
    at_low = at_high;
  }
  return roots;
}

std::vector<Crossing> equation_2_crossings(const FrequencyCurves& curves, int sector_count,
                                           const std::vector<int>& families, const SpeedRange& range) {
  std::vector<Crossing> crossings;
  for (int n = 1; n <= sector_count / 2; ++n)  // eq. 2 with f_c = 0
    append_crossings(crossings, curves, families, n, n, range);
  std::ranges::stable_sort(crossings, {}, &Crossing::speed);
  return crossings;
}

std::vector<Crossing> aliased_crossings(const FrequencyCurves& curves, int sector_count,
                                        const std::vector<int>& families, int lobes,
                                        const std::vector<int>& engine_orders, const SpeedRange& range) {
  std::vector<Crossing> crossings;
  for (const int order : engine_orders)
    if (lobes > 0 && order % lobes == 0)  // eq. 16: k N_l Omega; on n: eq. 17
      append_crossings(crossings, curves, families, order, signed_nodal_diameter(order, sector_count), range);
  std::ranges::stable_sort(crossings, {}, &Crossing::speed);
  return crossings;
}

bool predicts(const Crossing& crossing, const CriticalSpeed& critical, double tolerance) {
  return std::abs(crossing.engine_order - critical.naming_wave().engine_order) < same_order &&
         crossing.signed_nodal_diameter == critical.naming_wave().signed_nodal_diameter &&
         crossing.family == critical.naming_wave().family &&
         std::abs(crossing.speed - critical.speed) <= tolerance * critical.speed;
}

bool predicts(const std::vector<Crossing>& crossings, const CriticalSpeed& critical, double tolerance) {
  return std::ranges::any_of(crossings,
                             [&](const Crossing& crossing) { return predicts(crossing, critical, tolerance); });
}

RuleScore score(const std::vector<Crossing>& crossings, const std::vector<int>& moving, double tolerance,
                const std::vector<CriticalSpeed>& critical) {
  RuleScore result;
  double predicted = 0;
  for (const CriticalSpeed& speed : critical) {
    const bool hit = predicts(crossings, speed, tolerance);
    ++(hit ? result.hits : result.misses);
    result.summed_amplitudes += speed.amplitude;
    if (hit) predicted += speed.amplitude;
  }
  if (result.summed_amplitudes > 0) result.predicted_share = predicted / result.summed_amplitudes;
  for (const Crossing& crossing : crossings) {
    if (std::ranges::find(moving, std::abs(crossing.signed_nodal_diameter)) == moving.end()) continue;
    const bool met = std::ranges::any_of(
        critical, [&](const CriticalSpeed& speed) { return predicts(crossing, speed, tolerance); });
    if (met) continue;
    ++result.false_alarms;
    result.summed_alarms += crossing.amplitude;
    result.alarm_amplitude = std::max(result.alarm_amplitude, crossing.amplitude);
  }
  return result;
}

LinearRules linear_rules(const Response& response, const ContactLine& contact, const FrequencyCurves& curves,
                         const TipAmplitudes& amplitudes, const std::vector<CriticalSpeed>& critical,
                         const PostprocessParameters& parameters) {
  const SimulatedScene& scene = response.scene;
  const SpeedRange range{response.speeds.front().speed, response.speeds.back().speed};
  const std::vector<TravellingSpectrum> waves = largest_waves(response, contact, parameters.component);
  LinearRules rules{moving_waves(response, waves, curves, critical, amplitudes.largest.maxCoeff()), {}, {}, {}, {}};
  rules.equation_2 = equation_2_crossings(curves, scene.sector_count, rules.moving.families, range);
  rules.aliased = aliased_crossings(curves, scene.sector_count, rules.moving.families, scene.lobes,
                                    rules.moving.engine_orders, range);
  for (std::vector<Crossing>* crossings : {&rules.equation_2, &rules.aliased})
    read_amplitudes(*crossings, response, waves);
  const auto score_of = [&](const std::vector<Crossing>& crossings) {
    return score(crossings, scene.nodal_diameters, parameters.prediction_tolerance, critical);
  };
  rules.equation_2_score = score_of(rules.equation_2);
  rules.aliasing_score = score_of(rules.aliased);
  return rules;
}

std::vector<CriticalSpeed> with_predictions(std::vector<CriticalSpeed> critical, const LinearRules& rules,
                                            double tolerance) {
  for (CriticalSpeed& speed : critical) {
    speed.by_equation_2 = predicts(rules.equation_2, speed, tolerance);
    speed.by_aliasing = predicts(rules.aliased, speed, tolerance);
  }
  return critical;
}

}  // namespace tiprub::postprocess
