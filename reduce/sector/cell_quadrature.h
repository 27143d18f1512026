// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/sector/sector_mesh.h"

namespace tiprub {

/// The shape functions of one cell at its integration points.
struct CellPoints {
  std::vector<int> nodes;                                          ///< mesh nodes of the cell, in VTK's order
  Eigen::MatrixXd shape;                                           ///< [1] nodes x points
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, 3>> gradient;  ///< [1/m] d/dx, d/dy, d/dz; nodes x 3, one a point
  Eigen::VectorXd weight;                                          ///< [m^3] quadrature weight times Jacobian
  Eigen::Matrix3Xd position;                                       ///< [m] of the points
};

/// Quadrature on curved quadratic cells: the geometry has the shape functions of the displacement (cell_kind.h).
class CellQuadrature {
 public:
  /// Raises InputError if a cell is inverted at an integration point or at a node, with its number, part and place,
  /// or if the cells don't make a mesh: neighbours with different mid-side nodes, a face of three cells, or a
  /// quadrangle that meets triangles.
  explicit CellQuadrature(const SectorMesh& mesh);

  int cell_count() const { return static_cast<int>(cells_.size()); }
  const CellPoints& at(int cell) const { return cells_[cell]; }

 private:
  std::vector<CellPoints> cells_;  ///< some 17 kB a 20-node brick: less than one stiffness matrix
};

}  // namespace tiprub
