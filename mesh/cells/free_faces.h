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
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, outward, of its corners
  int cell = 0;                                      ///< that it belongs to

  std::size_t corners() const { return nodes.size() / 2; }
};

/// Cells by their nodes, of columns that are filled up with -1 (see nodes_of()).
std::vector<std::vector<int>> listed_cells(const Eigen::MatrixXi& columns);

/// Of cells whose nodes are in VTK's order; ordered by the numbers of their corners.
std::vector<FreeFace> free_faces(const Eigen::Matrix3Xd& nodes, const std::vector<std::vector<int>>& cells);

/// Those of `faces`, by number, that continue the faces `from` without an edge between them: neighbours whose normals
/// differ by less than 20 degrees, their neighbours, and so on; ascending, `from` among them.
std::vector<int> surface_patch(const std::vector<FreeFace>& faces, const std::vector<int>& from);

/// The first two cells that have the same nodes, or {-1, -1}. A mesh that is written twice has no free face.
std::array<int, 2> equal_cells(const std::vector<std::vector<int>>& cells);

/// Lists of cells or nodes by their names.
using NamedLists = std::map<std::string, std::vector<int>>;

/// Why these lists of cells can't be the parts of a sector; empty if they can. No part is empty, no cell is listed
/// twice or in two parts, and the nodes of a blade's tip line (`tips`, by the name of the blade's part) belong to
/// cells of that part, if it is there. What is computed by part (stress, energy) would else be told of another part.
std::string wrong_parts(const Eigen::MatrixXi& cells, const NamedLists& parts, const NamedLists& tips);

/// A value that a list has twice, or -1.
int listed_twice(std::vector<int> list);

}  // namespace tiprub
