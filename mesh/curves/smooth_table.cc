// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/curves/smooth_table.h"

#include <algorithm>
#include <cassert>

namespace tiprub::mesh {

namespace {

// The weighted harmonic mean of the slopes on both sides. It is zero at a turning point, so that nothing overshoots.
double inner_slope(double width_left, double chord_left, double width_right, double chord_right) {
  if (chord_left * chord_right <= 0.0) return 0.0;
  const double weight_left = 2.0 * width_right + width_left;
  const double weight_right = width_right + 2.0 * width_left;
  return (weight_left + weight_right) / (weight_left / chord_left + weight_right / chord_right);
}

}  // namespace

SmoothTable::SmoothTable(std::vector<std::array<double, 2>> points)
    : points_(std::move(points)), slopes_(points_.size(), 0.0) {
  assert(!points_.empty());
  const std::size_t last = points_.size() - 1;
  if (last == 0) return;
  const auto width = [&](std::size_t i) { return points_[i + 1][0] - points_[i][0]; };
  const auto chord = [&](std::size_t i) { return (points_[i + 1][1] - points_[i][1]) / width(i); };
  slopes_[0] = chord(0);
  slopes_[last] = chord(last - 1);
  for (std::size_t i = 1; i < last; ++i) slopes_[i] = inner_slope(width(i - 1), chord(i - 1), width(i), chord(i));
}

double SmoothTable::at(double x) const {
  if (x <= first_x()) return points_.front()[1];
  if (x >= last_x()) return points_.back()[1];
  const auto right = std::ranges::upper_bound(points_, x, {}, [](const auto& point) { return point[0]; });
  const std::size_t i = static_cast<std::size_t>(right - points_.begin()) - 1;
  const double width = points_[i + 1][0] - points_[i][0];
  const double t = (x - points_[i][0]) / width;
  const double rise = t * t * (3.0 - 2.0 * t);
  return points_[i][1] * (1.0 - rise) + points_[i + 1][1] * rise + width * t * (1.0 - t) * (1.0 - t) * slopes_[i] -
         width * t * t * (1.0 - t) * slopes_[i + 1];
}

SmoothTable read_chord_table(CaseTable& table, std::string_view key,
                             std::optional<std::vector<std::array<double, 2>>> fallback, const Range& range,
                             std::string_view unit, double factor) {
  std::vector<std::array<double, 2>> points = table.points(key, std::move(fallback), range, unit);
  if (points.size() > 1 && (points.front()[0] != 0.0 || points.back()[0] != 1.0))
    table.reject(key,
                 "must go from chord fraction 0 to chord fraction 1; give its first point x = 0 and its last x = 1");
  for (auto& point : points) point[1] *= factor;
  return SmoothTable(std::move(points));
}

double read_length_unit(CaseTable& table) {
  return table.choice<double>("length_unit", std::nullopt, {{1.0, "m"}, {1e-2, "cm"}, {1e-3, "mm"}, {0.0254, "in"}});
}

}  // namespace tiprub::mesh
