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

/// TurboGrid's curve files, as BladeGen writes them: points x y z, a line each, z the axis of rotation. Lines with a
/// '#' part the profiles of a blade; a mark after a point (le1, te1) is passed over. `length` is what a unit is in
/// metres.

/// hub.curve or shroud.curve: from inlet to outlet, at any angle. Raises InputError with the line.
MeridionalPath read_path_curve(const NamedText& file, double length);

/// profile.curve: of each profile the points once round, from hub to shroud. A profile's edges are its two points
/// that are farthest apart in the meridional plane; the one that comes first along the hub is the leading edge.
/// Raises InputError with the line.
FileBlade read_profile_curve(const NamedText& file, double length, const MeridionalPath& hub);

}  // namespace tiprub
