// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/import/cell_mesh.h"

namespace tiprub {

/// Free faces that a key of [mesh] selects, by number in CellMesh::faces: those all of whose corners are in the set
/// of that name, lie on "cylinder RADIUS" or "plane x|y|z PLACE" [m] to 1e-4 of the largest radius, or whose normal
/// is "normal X Y Z" to 5 degrees. Raises InputError, which lists the sets that there are.
std::vector<int> select_faces(const CellMesh& mesh, const std::string& key, const std::string& selection);

/// The nodes of a set. Raises InputError, which lists the sets that there are.
const std::vector<int>& select_nodes(const CellMesh& mesh, const std::string& key, const std::string& name);

/// The solids of a set. Raises InputError, which lists the sets that there are.
const std::vector<int>& select_cells(const CellMesh& mesh, const std::string& key, const std::string& name);

}  // namespace tiprub
