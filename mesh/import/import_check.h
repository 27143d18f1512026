// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/import/periodic_cuts.h"

namespace tiprub::mesh {

/// Raises InputError if the cells form several bodies that share no node and one of them is not clamped: its
/// stiffness would be singular. The pairs of faces of the cuts hold bodies together, too. `clamped` are free faces.
void require_held(const CellMesh& mesh, const PeriodicCuts& pairs, const std::vector<int>& clamped);

}  // namespace tiprub::mesh
