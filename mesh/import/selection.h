// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/import/cell_mesh.h"

namespace tiprub::mesh {

/// Free faces that a key of [mesh] selects, by number in CellMesh::faces: those all of whose corners are in the set
/// of that name, lie on "cylinder RADIUS" or "plane x|y|z PLACE" [m] to 1e-4 of the largest radius, or whose normal
/// is "normal X Y Z" to 5 degrees. Raises InputError, which lists the sets that there are.
std::vector<int> select_faces(const CellMesh& mesh, const std::string& key, const std::string& selection);

/// The nodes of a set. Raises InputError, which lists the sets that there are.
const std::vector<int>& select_nodes(const CellMesh& mesh, const std::string& key, const std::string& name);

/// The solids of a set. Raises InputError, which lists the sets that there are.
const std::vector<int>& select_cells(const CellMesh& mesh, const std::string& key, const std::string& name);

/// The sets that hold nodes of solids, for messages: "BORE, TIP", or "none".
std::string names_of_sets(const CellMesh& mesh);

/// At which end of the tip the leading edge is.
enum class LeadingEdge { low_z, high_z };

/// Nodes of a line in order from leading to trailing edge: by distance in the meridional plane from the end with the
/// lowest (highest) z, of the smallest radius among equal ones. Nodes that come no farther than those before them are
/// left out.
std::vector<int> ordered_line(const CellMesh& mesh, std::vector<int> nodes, LeadingEdge leading);

/// A line along a tip of which only the faces are known. Two paths lead along their outer edge from leading to
/// trailing edge. Where one begins or ends at the far corner of a blunt end, it goes across this end: that stretch,
/// beyond a corner of 60 degrees, is left out. Of what remains, the path with more nodes is taken. Raises InputError,
/// which names `key`, if the faces have no single outer edge.
std::vector<int> line_along_tip(const CellMesh& mesh, const std::vector<int>& faces, const std::string& key,
                                LeadingEdge leading);

}  // namespace tiprub::mesh
