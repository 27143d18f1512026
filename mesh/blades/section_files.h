// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace tiprub::mesh
