// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/import/periodic_cuts.h"

namespace tiprub::mesh {

/// Raises InputError if the cells form several bodies that share no node and one of them is not clamped: its
/// stiffness would be singular. The pairs of faces of the cuts hold bodies together, too. `clamped` are free faces.
void require_held(const CellMesh& mesh, const PeriodicCuts& pairs, const std::vector<int>& clamped);

/// What is doubtful about cuts that a search found in a mesh that goes round the axis: the flanks of a whole wheel's
/// blades may be turned into each other. Empty if a quarter turn or more is free of nodes.
std::string doubt_about_cuts(const CellMesh& mesh, const PeriodicCuts& cuts);

/// What is doubtful about a mesh without cuts that does not go round the axis: a quarter turn or more is free of its
/// nodes. Empty if nothing is.
std::string doubt_about_one_body(const CellMesh& mesh);

/// How many free faces these are, and from which to which radius: "26 faces, r 0.178 to 0.18 m".
std::string extent_of(const CellMesh& mesh, const std::vector<int>& faces);

}  // namespace tiprub::mesh
