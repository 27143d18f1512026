// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/blades/blade_section.h"

namespace tiprub {

/// Reads a plain table, the form in which NASA printed Rotor 37. A line with the word "section" begins a section.
/// Each line after it holds a point, from leading to trailing edge: z, r, theta of one side, theta of the other. Text
/// after a '#' is a remark. Raises InputError with the line.
FileBlade read_section_table(const NamedText& file, const FileUnits& units);

}  // namespace tiprub
