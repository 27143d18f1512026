// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstdint>

namespace tiprub {

/// Steps of a node's way around the casing: it begins one in `step`, 0 .. steps - 1, at the absolute angle (node
/// angle) + 2 pi (sector / N + step / steps).
struct CasingSteps {
  double node_angle = 0;  ///< [rad] of the contact node in sector 0
  int sector = 0;
  int sector_count = 0;  ///< N
  int steps = 0;         ///< a revolution
};

/// The area of the casing over which the node begins a step, of `areas` equal ones; area a spans 2 pi a/areas .. 2 pi
/// (a+1)/areas.
int casing_area(const CasingSteps& node, std::int64_t step, int areas);

/// How many steps of a revolution the node begins over each area. They differ by one where the areas don't divide the
/// steps; an area narrower than a step may have none.
Eigen::VectorXi steps_over_areas(const CasingSteps& node, int areas);

}  // namespace tiprub
