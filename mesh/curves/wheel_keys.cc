// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/curves/wheel_keys.h"

#include <optional>

namespace tiprub::mesh {

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
  return table.choice<double>("length_unit", std::nullopt, {{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"in", 0.0254}});
}

}  // namespace tiprub::mesh
