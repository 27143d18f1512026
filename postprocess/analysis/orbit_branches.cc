// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/orbit_branches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>

namespace tiprub {

namespace {

constexpr double flip_angle = 0.98 * std::numbers::pi;  // a multiplier as good as negative
constexpr double fold_angle = 0.02 * std::numbers::pi;  // as good as positive

/// Speeds at which the number of orbits may change: where branches end or turn back, and change their stability.
std::set<double> limits_of(const std::vector<OrbitBranch>& branches) {
  std::set<double> limits;
  for (const OrbitBranch& branch : branches)
    for (Eigen::Index i = 0; i < branch.speed.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == branch.speed.size();
      const bool turns =
          !is_end && (branch.speed[i] - branch.speed[i - 1]) * (branch.speed[i + 1] - branch.speed[i]) < 0;
      const bool changes = i > 0 && branch.attracts(i) != branch.attracts(i - 1);
      if (is_end || turns || changes) limits.insert(branch.speed[i]);
    }
  return limits;
}

OrbitRange count(const std::vector<OrbitBranch>& branches, double low, double high) {
  OrbitRange range{low, high, 0, 0};
  const double speed = 0.5 * (low + high);
  for (const OrbitBranch& branch : branches)
    for (Eigen::Index i = 1; i < branch.speed.size(); ++i) {
      const double from = branch.speed[i - 1], to = branch.speed[i];
      if ((from < speed) == (to < speed)) continue;
      ++range.orbits;
      if (branch.attracts(i) && branch.attracts(i - 1)) ++range.attracting;
    }
  return range;
}

}  // namespace

Instability instability(double angle) {
  if (angle > flip_angle) return Instability::flip;
  return angle < fold_angle ? Instability::fold : Instability::torus;
}

const char* name_of(Instability kind) {
  constexpr const char* names[] = {"fold", "flip", "torus"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<StabilityChange> stability_changes(const std::vector<OrbitBranch>& branches) {
  std::vector<StabilityChange> changes;
  for (const OrbitBranch& branch : branches)
    for (Eigen::Index i = 1; i < branch.speed.size(); ++i) {
      if (branch.attracts(i) == branch.attracts(i - 1)) continue;
      const double before = std::log(branch.multiplier[i - 1]), after = std::log(branch.multiplier[i]);
      const double along = std::isfinite(before) && std::isfinite(after) ? before / (before - after) : 0.5;
      const Eigen::Index repels = branch.attracts(i) ? i - 1 : i;
      changes.push_back({branch.speed[i - 1] + along * (branch.speed[i] - branch.speed[i - 1]),
                         instability(branch.multiplier_angle[repels])});
    }
  std::sort(changes.begin(), changes.end(),
            [](const auto& one, const auto& other) { return one.speed < other.speed; });
  return changes;
}

std::vector<OrbitRange> ranges_of_many_orbits(const std::vector<OrbitBranch>& branches) {
  const std::set<double> limits = limits_of(branches);
  std::vector<OrbitRange> ranges;
  for (auto low = limits.begin(); low != limits.end(); ++low) {
    const auto high = std::next(low);
    if (high == limits.end()) break;
    const OrbitRange range = count(branches, *low, *high);
    const bool goes_on = !ranges.empty() && ranges.back().high == range.low && ranges.back().orbits == range.orbits &&
                         ranges.back().attracting == range.attracting;
    if (goes_on)
      ranges.back().high = range.high;
    else if (range.orbits > 1)
      ranges.push_back(range);
  }
  return ranges;
}

}  // namespace tiprub
