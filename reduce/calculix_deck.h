// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "reduce/sector/reduction_parameters.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub {

/// Writes the sector as decks that CalculiX runs as they are: `mesh.inp` (nodes, C3D10, C3D15 and C3D20 elements,
/// sets, cyclic symmetry) and one `speed_<rpm>.inp` a verification speed (a static step under spin where it turns,
/// with NLGEOM for nonlinear prestress, then the lowest frequencies of every nodal diameter). `folder` is made if it
/// doesn't exist. Raises InputError for kinds of cells that CalculiX doesn't have, and RunError if a file can't be
/// written.
void write_calculix_decks(const SectorMesh& mesh, const ReductionParameters& parameters,
                          const std::filesystem::path& folder);

}  // namespace tiprub
