// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/import/periodic_cuts.h"

namespace tiprub::mesh {

/// Raises InputError if the cells form several bodies that share no node and one of them is not clamped: its
/// stiffness would be singular. The pairs of faces of the cuts hold bodies together, too. `clamped` are free faces.
void require_held(const CellMesh& mesh, const PeriodicCuts& pairs, const std::vector<int>& clamped);

/// What is doubtful about a mesh without cuts that does not go round the axis: a quarter turn or more is free of its
/// nodes. Empty if nothing is.
std::string doubt_about_one_body(const CellMesh& mesh);

}  // namespace tiprub::mesh
