// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <vector>

#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// The shape functions of one cell at its integration points.
struct CellPoints {
  int cell = 0;
  std::vector<int> nodes;                                          ///< mesh nodes that the cell moves with
  Eigen::MatrixXd shape;                                           ///< [1] nodes x points
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, 3>> gradient;  ///< [1/m] d/dx, d/dy, d/dz; nodes x 3, one a point
  Eigen::VectorXd weight;                                          ///< [m^3] quadrature weight times Jacobian
  Eigen::Matrix3Xd position;                                       ///< [m] of the points
};

/// An integral over one cell.
struct CellIntegral {
  std::vector<int> nodes;
  Eigen::MatrixXd value;
};

/// A sector's cells as finite elements of deal.II (Arndt et al. 2021), of the kinds in reduce/theory.md, section 1: a
/// triangulation, a DoFHandler that numbers it, and an isoparametric mapping for which the nodes of the file,
/// mid-side nodes included, are the geometry. deal.II 9.4 has no quadratic pyramid: for these the table of
/// cell_kind.h serves.
///
/// Bricks of 20 nodes and wedges of 15 are subspaces, by constraints that are resolved in the shape functions before
/// anything is integrated: a matrix of 60 dofs costs half of one of 81. Where the mesh has cubic functions (see
/// cubic_bricks.h), displacements are FE_Q(3), and the geometry is that of the quadratic brick.
///
/// Shape functions are computed again for each integral, so that no memory grows with the number of cells.
class FiniteElements {
 public:
  /// Raises InputError if the cells make no sound mesh (see cell_checks.h), or if one is inverted at an integration
  /// point. The mesh must outlive this object.
  explicit FiniteElements(const SectorMesh& mesh, int threads = 1);
  FiniteElements(const FiniteElements&) = delete;
  FiniteElements& operator=(const FiniteElements&) = delete;
  ~FiniteElements();

  int cell_count() const;
  /// Calls the visitor for one cell after the other.
  void visit(const std::function<void(const CellPoints&)>& visitor) const;
  /// Integrates over cells on all threads, and hands the integrals over one by one in the order of `cells`, so that
  /// rounding is the same on any number of threads. The first exception is raised again here.
  void integrate(const std::vector<int>& cells, const std::function<Eigen::MatrixXd(const CellPoints&)>& integral,
                 const std::function<void(const CellIntegral&)>& take) const;

 private:
  class Space;
  std::unique_ptr<const Space> space_;
  int threads_;
};

}  // namespace tiprub::reduce
