// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/blades/blade_section.h"

namespace tiprub {

/// A plain table: a line that begins with the word "section", then its points, a line each, from leading to trailing
/// edge: z, r, theta of one side, theta of the other. What stands after a '#' is a remark. So NASA's tables of Rotor
/// 37 are printed. Raises InputError with the line.
FileBlade read_section_table(const NamedText& file, const FileUnits& units);

}  // namespace tiprub
