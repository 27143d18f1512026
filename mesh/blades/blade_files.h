// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/blades/blade_section.h"

namespace tiprub::mesh {

/// Reads a plain table, the form in which NASA printed Rotor 37. A line with the word "section" begins a section.
/// Each line after it holds a point, from leading to trailing edge: z, r, theta of one side, theta of the other. Text
/// after a '#' is a remark. Raises InputError with the line.
FileBlade read_section_table(const NamedText& file, const FileUnits& units);

/// Reads BladeGen's meanline data (.rtzt), as Ansys' "BladeModeler User's Guide" publishes it under "Standard UserIO
/// Formats": number of blades; 1 with splitters, else 0; then of each blade its pitch fraction, the number of layers,
/// N or T (thickness normal to the mean line in the layer, or along the circle), and of each layer its span fraction,
/// its number of points, and the points r, theta [rad], z, thickness. `length` is the file's unit in metres. Points
/// without thickness lie outside the blade and are left out. Raises InputError with the line.
FileBlade read_meanline(const NamedText& file, double length);

/// A hub or a shroud: points in the meridional plane from inlet to outlet, with straight lines between.
using MeridionalPath = std::vector<MeridionalPoint>;

/// The place on a path that is nearest to a point.
struct PlaceOnPath {
  double along;   ///< length from the inlet [m]
  double beside;  ///< distance of the point, positive to the left of the way [m]
};
PlaceOnPath nearest_on(const MeridionalPath& path, const MeridionalPoint& point);

/// The part of a blade between hub and shroud, as sections at equal fractions of its height. Its tip ends `clearance`
/// [m] before the shroud, or at the last section where that lies lower. Raises InputError, with the names of both
/// files, where the blade doesn't reach the hub.
FileBlade cut_to_path(const FileBlade& blade, const MeridionalPath& hub, const MeridionalPath& shroud,
                      double clearance, const std::string& blade_name, const std::string& hub_name);

/// The two readers below take TurboGrid's curve files as BladeGen writes them. Each line holds one point x y z, with
/// z the axis of rotation. A line with a '#' separates two profiles; a mark after a point (le1, te1) is ignored.
/// `length` is the file's unit in metres.

/// Reads hub.curve or shroud.curve, from inlet to outlet; the angles of its points don't matter. Raises InputError
/// with the line.
MeridionalPath read_path_curve(const NamedText& file, double length);

/// Reads profile.curve: the points once round each profile, from hub to shroud. The edges of a profile are the two
/// points that are farthest apart in the meridional plane; the one that comes first along the hub is the leading
/// edge. Raises InputError with the line.
FileBlade read_profile_curve(const NamedText& file, double length, const MeridionalPath& hub);

}  // namespace tiprub::mesh
