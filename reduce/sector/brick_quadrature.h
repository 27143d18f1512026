// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/sector/sector_mesh.h"

namespace tiprub {

/// The shape functions of one brick at its 27 Gauss points.
struct BrickPoints {
  std::vector<int> nodes;                                          ///< mesh nodes of the brick; 20 or 27
  Eigen::MatrixXd shape;                                           ///< [1] nodes x points
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, 3>> gradient;  ///< [1/m] d/dx, d/dy, d/dz; nodes x 3, one a point
  Eigen::VectorXd weight;                                          ///< [m^3] quadrature weight times Jacobian
  Eigen::Matrix3Xd position;                                       ///< [m] of the points
};

/// Quadrature on curved 20- and 27-node bricks, by deal.II: the triangulation from the corners, a quadratic mapping
/// from all nodes, FE_Q(2) for the 27-node shape functions. The 20-node brick is the 27-node one whose face and cell
/// centres follow the serendipity formulas
///     face centre = -1/4 corners + 1/2 mid-sides,   cell centre = -1/4 corners + 1/4 mid-sides,
/// for the geometry as for the displacement; 3 x 3 x 3 Gauss points integrate both in full (CalculiX's C3D20).
class BrickQuadrature {
 public:
  /// Raises InputError if a cell is inverted at a Gauss point or at a node, with its number, part and place, or if
  /// the cells don't make a mesh.
  explicit BrickQuadrature(const SectorMesh& mesh);

  int cell_count() const { return static_cast<int>(cells_.size()); }
  const BrickPoints& at(int cell) const { return cells_[cell]; }

 private:
  std::vector<BrickPoints> cells_;  ///< some 17 kB a 20-node brick: less than one stiffness matrix
};

}  // namespace tiprub
