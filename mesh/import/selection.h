// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/import/cell_mesh.h"

namespace tiprub::mesh {

/// The free faces that a key of [mesh] selects, as numbers in CellMesh::faces. `selection` is one of
///   the name of a set                       all corners of the face are in the set; a surface of this name comes
///                                           before a set of nodes, and that before a set of elements;
///   "cylinder RADIUS", "plane x|y|z PLACE"  [m] all corners lie on it, to 1e-4 of the largest radius;
///   "normal X Y Z"                          the normal of the face has this direction, to 5 degrees.
/// Raises InputError, which lists the available sets.
std::vector<int> select_faces(const CellMesh& mesh, const std::string& key, const std::string& selection);

/// The nodes of a set. Raises InputError, which lists the available sets.
const std::vector<int>& select_nodes(const CellMesh& mesh, const std::string& key, const std::string& name);

/// The solids of a set. Raises InputError, which lists the available sets.
const std::vector<int>& select_cells(const CellMesh& mesh, const std::string& key, const std::string& name);

/// The names of the sets that contain nodes of solids, for messages: "BORE, TIP", or "none".
std::string names_of_sets(const CellMesh& mesh);

/// The end of the tip at which the leading edge lies.
enum class LeadingEdge { low_z, high_z };

/// The nodes of a line from leading to trailing edge, ordered by their distance in the meridional plane from the
/// first node: that with the lowest (or highest) z and, among equal ones, the smallest radius. Nodes that are no
/// farther away than the node before them are left out.
std::vector<int> ordered_line(const CellMesh& mesh, std::vector<int> nodes, LeadingEdge leading);

/// The nodes of a line along a tip of which only the faces are known. Two paths along the outer edge of the faces
/// lead from leading to trailing edge. Where such a path begins or ends at the far corner of a blunt end, it also
/// runs across that end; this stretch, beyond a corner of 60 degrees, is left out. The path with more remaining nodes
/// is taken. Raises InputError, which names `key`, if the faces do not have a single outer edge.
std::vector<int> line_along_tip(const CellMesh& mesh, const std::vector<int>& faces, const std::string& key,
                                LeadingEdge leading);

}  // namespace tiprub::mesh
