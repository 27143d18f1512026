// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/adaptive_speeds.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>

#include "simulate/motion/column.h"

namespace tiprub::simulate {

namespace {

constexpr double inside = 0.9;        // of the goal: a new sample lies within it
constexpr double lopsided = 8;        // ratio of the two sides above which the larger one is narrowed first
constexpr double step_out = 3;        // times the smaller side
constexpr double candidate = 0.5;     // of the prominence: a coarse curve underestimates a peak
constexpr double nearly = 0.95;       // of the height of severe peaks, for the same reason
constexpr double clear_valley = 0.5;  // of a peak's height: a lower valley is deep enough for any prominence
constexpr double beyond_jump = 5e-3;  // of the speed: error of a scan in the place of a jump
constexpr double of_scan_speed = 2;   // times that of the goal
constexpr double of_scan_fall = 0.05, of_scan_amplitude = 0.05;
constexpr double finest = 2e-4;  // of the speed: no interval becomes narrower

Eigen::VectorXd amplitudes(const SampledCurve& curve) {
  return column(curve, &SampledSpeed::amplitude);
}

/// Candidates that may prove to be peaks when more speeds are computed.
std::vector<Peak> candidates(const SampledCurve& curve, const LocationGoal& goal) {
  PeakMeasure measure = goal.peaks;
  measure.prominence *= candidate;
  measure.apart *= candidate;
  measure.severe *= nearly;
  return named_peaks(amplitudes(curve), measure);
}

PeakTop top_at(const SampledCurve& curve, Eigen::Index place) {
  const auto i = static_cast<std::size_t>(place);
  return {curve[i - 1], curve[i], curve[i + 1]};
}

void close_in(const PeakTop& peak, const LocationGoal& goal, std::set<double>& next) {
  const double width = inside * goal.speed * peak.top.speed;
  for (const auto& [side, sign] : {std::pair(peak.left_gap(), -1.0), std::pair(peak.right_gap(), 1.0)})
    if (side > goal.speed * peak.top.speed) next.insert(peak.top.speed + sign * std::max(width, side / lopsided));
}

/// Halves each gap beside a peak in which the response may rise too far above it.
void halve_gaps(const SampledCurve& curve, Eigen::Index place, const LocationGoal& goal, std::set<double>& next) {
  const Eigen::VectorXd speed = column(curve, &SampledSpeed::speed), amplitude = amplitudes(curve);
  for (const int step : {-1, 1}) {
    const double gap = speed[place + step] - speed[place];
    if (std::abs(gap) > 2 * goal.narrowest * speed[place] &&
        rise_beside(speed, amplitude, place, step) > goal.amplitude * amplitude[place])
      next.insert(speed[place] + gap / 2);
  }
}

void refine_peak(const SampledCurve& curve, Eigen::Index place, const LocationGoal& goal, std::set<double>& next) {
  const PeakTop peak = top_at(curve, place);
  const double left = peak.left_gap(), right = peak.right_gap(), wide = goal.speed * peak.top.speed;
  if (std::max(left, right) <= wide) {
    halve_gaps(curve, place, goal, next);
  } else if (std::max(left, right) > lopsided * std::min(left, right)) {
    next.insert(peak.top.speed + (left > right ? -1 : 1) * step_out * std::min(left, right));
  } else if (std::abs(peak.vertex() - peak.top.speed) > wide / 2) {
    next.insert(peak.vertex());
  } else {
    close_in(peak, goal, next);
  }
}

/// On each side of a peak, adds a speed beside the last one that is nearly as high as the peak if the next lower one
/// is far away, because a peak that is a few percent higher may hide between the two.
void look_beside(const SampledCurve& curve, std::size_t peak, const LocationGoal& goal, std::set<double>& next) {
  const SampledSpeed& top = curve[peak];
  for (const int step : {-1, 1}) {
    std::size_t i = peak;
    while (i > 0 && i + 1 < curve.size() && curve[i].amplitude >= (1 - goal.fall) * top.amplitude) i += step;
    const SampledSpeed &low = curve[i], &high = curve[i - step];
    const double beyond = goal.flank * top.speed;
    if (std::abs(low.speed - high.speed) > beyond) next.insert(high.speed + inside * step * beyond);
  }
}

void refine_jumps(const SampledCurve& curve, const LocationGoal& goal, std::set<double>& next) {
  for (const std::size_t i : located_jumps(curve, goal)) {
    const double low = curve[i].speed, high = curve[i + 1].speed;
    if (high - low > goal.jump_width * high) next.insert(0.5 * (low + high));
  }
}

/// Whether a speed of `full` between two speeds of the scan already shows a clear valley.
bool falls_between(const SampledCurve& full, double from, double to, double height) {
  return std::ranges::any_of(full, [&](const SampledSpeed& at) {
    return at.speed >= std::min(from, to) && at.speed <= std::max(from, to) && at.amplitude < clear_valley * height;
  });
}

std::vector<double> without(std::set<double> speeds, const SampledCurve& curve) {
  for (const SampledSpeed& there : curve) speeds.erase(there.speed);
  return {speeds.begin(), speeds.end()};
}

}  // namespace

LocationGoal LocationGoal::of_damping(double ratio) {
  LocationGoal goal;
  goal.speed = std::clamp(inside * resolving_spacing * ratio, finest, goal.speed);
  return goal;
}

LocationGoal LocationGoal::of_scan() const {
  LocationGoal goal = *this;
  goal.speed *= of_scan_speed;
  goal.fall = of_scan_fall;
  goal.amplitude = of_scan_amplitude;
  goal.jump_reach = 1;
  return goal;
}

std::vector<double> speeds_to_scan(const std::vector<double>& given, int per_interval, double damping_ratio,
                                   std::size_t most) {
  std::vector<double> speeds;
  for (double widest = inside * finding_spacing * std::max(damping_ratio, finest);; widest *= 2) {
    speeds = given;
    std::size_t more = 0;
    for (std::size_t i = 0; i + 1 < given.size(); ++i) {
      const double gap = given[i + 1] - given[i];
      const int parts = std::max(per_interval + 1, static_cast<int>(std::ceil(gap / (widest * given[i]))));
      more += static_cast<std::size_t>(parts - per_interval - 1);
      for (int part = 1; part < parts; ++part) speeds.push_back(given[i] + gap * part / parts);
    }
    if (more == 0 || speeds.size() <= most) return speeds;
  }
}

std::vector<double> speeds_to_refine(const SampledCurve& curve, const LocationGoal& goal) {
  std::set<double> next;
  const std::vector<Peak> peaks = candidates(curve, goal);
  for (const Peak& peak : peaks) refine_peak(curve, peak.index, goal, next);
  refine_jumps(curve, goal, next);
  if (next.empty())
    for (const Peak& peak : peaks) look_beside(curve, static_cast<std::size_t>(peak.index), goal, next);
  return without(std::move(next), curve);
}

std::vector<double> speeds_to_confirm(const SampledCurve& scan, const SampledCurve& full, const LocationGoal& goal) {
  std::set<double> next;
  for (const Peak& peak : candidates(scan, goal)) {
    const PeakTop highest = top_at(scan, peak.index);
    const double top = highest.vertex();
    for (const double side : {-inside, 0.0, inside}) next.insert(top * (1 + side * goal.speed));
    for (const Eigen::Index place : {peak.left_valley, peak.right_valley}) {
      const double valley = scan[static_cast<std::size_t>(place)].speed;
      if (!falls_between(full, valley, top, highest.top.amplitude)) next.insert(valley);
    }
  }
  LocationGoal narrow = goal;
  narrow.jump_reach = goal.jump_width;
  for (const std::size_t i : located_jumps(scan, narrow))
    next.insert({std::max((1 - beyond_jump) * scan[i].speed, scan.front().speed), scan[i].speed, scan[i + 1].speed,
                 std::min((1 + beyond_jump) * scan[i + 1].speed, scan.back().speed)});
  return without(std::move(next), full);
}

std::vector<std::size_t> located_jumps(const SampledCurve& curve, const LocationGoal& goal) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const SampledSpeed &low = curve[i], &high = curve[i + 1];
    const double change = std::abs(high.amplitude - low.amplitude);
    const bool near = high.speed - low.speed <= goal.jump_reach * high.speed;
    if (near && change > goal.jump * std::max(low.amplitude, high.amplitude)) places.push_back(i);
  }
  return places;
}

std::vector<std::size_t> located_peaks(const SampledCurve& curve, const LocationGoal& goal) {
  std::vector<std::size_t> places;
  for (const Peak& peak : named_peaks(amplitudes(curve), goal.peaks))
    places.push_back(static_cast<std::size_t>(peak.index));
  return places;
}

}  // namespace tiprub::simulate
