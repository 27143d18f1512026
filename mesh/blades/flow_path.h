// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/blades/blade_section.h"

namespace tiprub {

/// A hub or a shroud: points in the meridional plane from inlet to outlet, with straight lines between.
using MeridionalPath = std::vector<MeridionalPoint>;

/// The place on a path that is nearest to a point.
struct PlaceOnPath {
  double along;   ///< length from the inlet [m]
  double beside;  ///< distance of the point, positive to the left of the way [m]
};
PlaceOnPath nearest_on(const MeridionalPath& path, const MeridionalPoint& point);

/// What of a blade stands between hub and shroud, as sections of equal share of that height; its tip ends `clearance`
/// [m] before the shroud, or at the last section where that lies lower. Raises InputError, with the names of both
/// files, where the blade doesn't reach the hub.
FileBlade cut_to_path(const FileBlade& blade, const MeridionalPath& hub, const MeridionalPath& shroud,
                      double clearance, const std::string& blade_name, const std::string& hub_name);

}  // namespace tiprub
