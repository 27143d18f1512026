// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/linear_criterion.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "postprocess/tables/units.h"

namespace tiprub {

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

void sort_by_speed(std::vector<Crossing>& crossings) {
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.speed < b.speed; });
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
  sort_by_speed(crossings);
  return crossings;
}

std::vector<Crossing> aliased_crossings(const FrequencyCurves& curves, int sector_count,
                                        const std::vector<int>& families, int lobes,
                                        const std::vector<int>& engine_orders, const SpeedRange& range) {
  std::vector<Crossing> crossings;
  for (const int order : engine_orders)
    if (lobes > 0 && order % lobes == 0)  // eq. 16: k N_l Omega; on n: eq. 17
      append_crossings(crossings, curves, families, order, signed_nodal_diameter(order, sector_count), range);
  sort_by_speed(crossings);
  return crossings;
}

}  // namespace tiprub
