// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace tiprub {

/// The path of a contact node around the casing. The node begins step 0 .. steps - 1 at the absolute angle
/// node_angle + 2 pi (sector / N + step / steps).
struct CasingSteps {
  double node_angle = 0;  ///< [rad] of the contact node in sector 0
  int sector = 0;
  int sector_count = 0;  ///< N
  int steps = 0;         ///< per revolution
};

/// The casing is divided into `areas` equal areas; area a spans 2 pi a/areas .. 2 pi (a+1)/areas. Returns the area
/// over which the node begins a step.
inline int casing_area(const CasingSteps& node, std::int64_t step, int areas) {
  const double turns = node.node_angle / (2 * std::numbers::pi) +
                       static_cast<double>(node.sector) / node.sector_count +
                       static_cast<double>(step % node.steps) / node.steps;
  return std::min(static_cast<int>((turns - std::floor(turns)) * areas), areas - 1);
}

/// How many steps of a revolution the node begins over each area. The counts differ by one where the number of areas
/// does not divide the number of steps; an area narrower than a step may have none.
inline Eigen::VectorXi steps_over_areas(const CasingSteps& node, int areas) {
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(areas);
  for (int step = 0; step < node.steps; ++step) ++counts[casing_area(node, step, areas)];
  return counts;
}

}  // namespace tiprub
