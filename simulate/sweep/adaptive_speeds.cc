// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/adaptive_speeds.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>

#include "simulate/response/peaks.h"

namespace tiprub {

namespace {

constexpr double inside = 0.9;     // of the goal: a new sample lands within it
constexpr double lopsided = 8;     // ratio of the two sides at which the larger one is halved first
constexpr double candidate = 0.5;  // of the prominence: a coarse curve shows a peak lower than it is

Eigen::VectorXd amplitudes(const std::vector<SampledSpeed>& curve) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(curve.size()));
  for (std::size_t i = 0; i < curve.size(); ++i) values[static_cast<Eigen::Index>(i)] = curve[i].amplitude;
  return values;
}

/// A peak's sample between its two neighbours.
struct Triple {
  const SampledSpeed &left, &top, &right;

  double left_side() const { return top.speed - left.speed; }
  double right_side() const { return right.speed - top.speed; }
  ParabolaTop parabola() const {
    return parabola_top({left.speed, top.speed, right.speed}, {left.amplitude, top.amplitude, right.amplitude});
  }
};

void close_in(const Triple& peak, const LocationGoal& goal, std::set<double>& next) {
  const double width = inside * goal.speed * peak.top.speed;
  for (const auto& [side, sign] : {std::pair(peak.left_side(), -1.0), std::pair(peak.right_side(), 1.0)})
    if (side > goal.speed * peak.top.speed) next.insert(peak.top.speed + sign * std::max(width, side / lopsided));
}

void refine_peak(const Triple& peak, const LocationGoal& goal, std::set<double>& next) {
  if (peak.top.kind == SampledSpeed::Kind::scanned) {
    next.insert(peak.top.speed);
    return;
  }
  const double left = peak.left_side(), right = peak.right_side(), wide = goal.speed * peak.top.speed;
  if (std::max(left, right) <= wide) {
    for (const SampledSpeed* side : {&peak.left, &peak.right})
      if (side->kind == SampledSpeed::Kind::scanned) next.insert(side->speed);
    const ParabolaTop parabola = peak.parabola();
    const bool apart = std::abs(parabola.offset) > goal.narrowest * peak.top.speed;
    if (next.empty() && apart && parabola.height > goal.amplitude * peak.top.amplitude)
      next.insert(peak.top.speed + parabola.offset);
    return;
  }
  const double vertex = peak.parabola().offset;
  if (std::max(left, right) > lopsided * std::min(left, right))
    next.insert(peak.top.speed + (left > right ? -left / 2 : right / 2));
  else if (std::abs(vertex) > wide / 2)
    next.insert(peak.top.speed + vertex);
  else
    close_in(peak, goal, next);
}

/// On each side of a peak, the middle between the last speed that is nearly as high and the first that is not, if
/// they are far apart: scanned ones between them are too coarse to show a peak a few percent higher.
void look_beside(const std::vector<SampledSpeed>& full, std::size_t peak, const LocationGoal& goal,
                 std::set<double>& next) {
  const SampledSpeed& top = full[peak];
  for (const int step : {-1, 1}) {
    std::size_t i = peak;
    while (i > 0 && i + 1 < full.size() && full[i].amplitude >= (1 - goal.fall) * top.amplitude) i += step;
    const SampledSpeed &low = full[i], &high = full[i - step];
    if (std::abs(low.speed - high.speed) > goal.flank * top.speed) next.insert(0.5 * (low.speed + high.speed));
  }
}

void refine_jumps(const std::vector<SampledSpeed>& curve, const LocationGoal& goal, std::set<double>& next) {
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const SampledSpeed &low = curve[i], &high = curve[i + 1];
    const double change = std::abs(high.amplitude - low.amplitude);
    if (change <= goal.jump * std::max(low.amplitude, high.amplitude)) continue;
    if (high.speed - low.speed > goal.speed * high.speed) next.insert(0.5 * (low.speed + high.speed));
  }
}

}  // namespace

std::vector<double> speeds_to_refine(const std::vector<SampledSpeed>& curve, const LocationGoal& goal) {
  std::set<double> next;
  for (const Peak& peak : find_peaks(amplitudes(curve), candidate * goal.prominence)) {
    const auto i = static_cast<std::size_t>(peak.index);
    std::set<double> here;
    refine_peak({curve[i - 1], curve[i], curve[i + 1]}, goal, here);
    next.merge(here);
    for (const Eigen::Index valley : {peak.left_valley, peak.right_valley})
      if (const SampledSpeed& low = curve[static_cast<std::size_t>(valley)]; low.kind == SampledSpeed::Kind::scanned)
        next.insert(low.speed);
  }
  refine_jumps(curve, goal, next);
  if (next.empty()) {
    std::vector<SampledSpeed> full = curve;
    std::erase_if(full, [](const SampledSpeed& there) { return there.kind == SampledSpeed::Kind::scanned; });
    for (const std::size_t peak : located_peaks(full, goal)) look_beside(full, peak, goal, next);
  }
  for (const SampledSpeed& there : curve)
    if (there.kind == SampledSpeed::Kind::full) next.erase(there.speed);
  return {next.begin(), next.end()};
}

std::vector<std::size_t> located_peaks(const std::vector<SampledSpeed>& curve, const LocationGoal& goal) {
  std::vector<std::size_t> places;
  for (const Peak& peak : find_peaks(amplitudes(curve), goal.prominence))
    places.push_back(static_cast<std::size_t>(peak.index));
  return places;
}

}  // namespace tiprub
