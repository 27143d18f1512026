// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce::test {

/// Places a point of the unit cube (radial, around, axial) in space [m].
using Placement = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// Whether the last bricks around meet the first ones.
enum class Around { open, closed };

/// A structured block of quadratic bricks in gmsh's node order, made without any mesher. Nodes are numbered around
/// first, so that the nodes of a sector stand together in a closed ring.
class BrickGrid {
 public:
  BrickGrid(const std::array<int, 3>& bricks, int nodes_per_brick, Around around);

  /// Node at half-brick steps i (radial), j (around), k (axial); -1 where a 20-node brick has none.
  int node(int i, int j, int k) const;
  /// All nodes with a given step in one direction.
  std::vector<int> layer(int direction, int step) const;
  /// Faces of the last radial bricks, outwards, of `count` bricks around from `first` on; 8 or 9 x faces.
  Eigen::MatrixXi outer_faces(int first, int count) const;
  /// Nodes and cells; the groups are left empty.
  SectorMesh place(const Placement& placement) const;

 private:
  int steps(int direction) const;

  std::array<int, 3> bricks_;
  int nodes_per_brick_;
  Around around_;
  std::vector<int> number_;  ///< of each lattice point
};

}  // namespace tiprub::reduce::test
