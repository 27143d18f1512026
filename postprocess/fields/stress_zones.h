// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reduce/model/fields_file.h"

namespace tiprub {

/// Where a sector's stress can be read, and where it is unbounded in the exact solution, so that it grows as the mesh
/// is refined.
enum class StressZone {
  body,       ///< neither of the others
  tip_patch,  ///< near the tip line: the casing pushes at single nodes
  clamp_rim,  ///< near the edge of the clamped surface
};

/// Lengths don't come from the mesh, so that meshes can be compared.
struct StressZones {
  double tip_patch = 0;             ///< [m] from the line through the contact nodes
  double clamp_rim = 0;             ///< [m] from the clamp's edge, in the meridional plane
  std::vector<StressZone> at_node;  ///< by node of the sector
};

/// `tip_patch` in m; 0: 5 % of the tip line's length. The clamp's rim is as wide. Raises InputError if no node is
/// left.
StressZones stress_zones(const SectorFields& sector, double tip_patch);

/// [m] along the tip line, through all of its nodes that the fields know.
double tip_length(const SectorFields& sector);

}  // namespace tiprub
