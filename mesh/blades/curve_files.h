// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/blades/blade_section.h"
#include "mesh/blades/flow_path.h"

namespace tiprub {

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
