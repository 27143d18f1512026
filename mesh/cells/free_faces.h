// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace tiprub {

/// A face that belongs to only one cell.
struct FreeFace {
  std::vector<int> nodes;  ///< corners around, seen from outside, then the mid-sides between them
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit normal of its corners, outward
  int cell = 0;                                      ///< number of its cell

  std::size_t corners() const { return nodes.size() / 2; }
  /// The corners at the ends of edge k, the smaller number first.
  std::array<int, 2> edge(std::size_t k) const;
};

/// The nodes of each cell, from columns that are filled up with -1 (see nodes_of()).
std::vector<std::vector<int>> listed_cells(const Eigen::MatrixXi& columns);

/// The free faces of cells whose nodes are in VTK's order; ordered by the numbers of their corners.
std::vector<FreeFace> free_faces(const Eigen::Matrix3Xd& nodes, const std::vector<std::vector<int>>& cells);

/// The numbers of those of these faces that meet at each edge.
std::map<std::array<int, 2>, std::vector<int>> faces_at_edges(const std::vector<FreeFace>& faces,
                                                              const std::vector<int>& numbers);

/// The faces that continue the surface of the faces `from` without an edge: neighbours whose normals differ by less
/// than 20 degrees, their neighbours, and so on. Numbers in `faces`, ascending, `from` included.
std::vector<int> surface_patch(const std::vector<FreeFace>& faces, const std::vector<int>& from);

/// The numbers of the first two cells with the same nodes, or {-1, -1}. Without this check, a mesh that was written
/// twice would have no free faces.
std::array<int, 2> equal_cells(const std::vector<std::vector<int>>& cells);

/// Lists of cells or nodes, by name.
using NamedLists = std::map<std::string, std::vector<int>>;

/// The reason why these lists of cells cannot be the parts of a sector; empty if they can. No part may be empty, no
/// cell may be listed twice or belong to two parts, and the nodes of the tip line of a blade (`tips`, by the name of
/// the part) must belong to cells of that part, if it exists. Otherwise results by part (stress, energy) would be
/// attributed to the wrong part.
std::string wrong_parts(const Eigen::MatrixXi& cells, const NamedLists& parts, const NamedLists& tips);

/// A value that occurs twice in a list, or -1.
int listed_twice(std::vector<int> list);

}  // namespace tiprub
