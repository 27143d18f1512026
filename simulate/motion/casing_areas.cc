// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/motion/casing_areas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiprub {

int casing_area(const CasingSteps& node, std::int64_t step, int areas) {
  const double turns = node.node_angle / (2 * std::numbers::pi) +
                       static_cast<double>(node.sector) / node.sector_count +
                       static_cast<double>(step % node.steps) / node.steps;
  return std::min(static_cast<int>((turns - std::floor(turns)) * areas), areas - 1);
}

Eigen::VectorXi steps_over_areas(const CasingSteps& node, int areas) {
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(areas);
  for (int step = 0; step < node.steps; ++step) ++counts[casing_area(node, step, areas)];
  return counts;
}

}  // namespace tiprub
