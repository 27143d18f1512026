// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/operators/cyclic_transformation.h"
#include "reduce/operators/sector_factor.h"

namespace tiprub::reduce {

/// Whether the contact nodes, or the displacements of the contact segments, are held.
enum class ContactNodes { free, fixed };

/// Solves T^H K T x = b of one nodal diameter (eq. 6) from the one factor of the sector's K. Only the Schur
/// complement on cut faces and contact nodes depends on the phase. A nodal diameter costs a dense Cholesky
/// factorization of it, and each block of right-hand sides costs two passes through the sector's factor.
///
/// Contact nodes are rows of the Schur complement; segments, B' u = q, are not. Psi = K^-1 B (B' K^-1 B)^-1 holds the
/// shapes in which one segment moves and the others don't, so x - Psi B' x is the solution with all segments held.
/// This costs one solve for each segment at the start, and leaves the factor as it is.
class CyclicSolver {
 public:
  /// Raises RunError if K of this nodal diameter is not positive definite.
  CyclicSolver(const SectorFactor& factor, const CyclicTransformation& transform);

  /// x with K x = b; independent x columns; b must be real for a standing transform. With fixed contact nodes,
  /// their rows of b are ignored and their rows of x are zero; with fixed segments, B' x is zero.
  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& load, ContactNodes contact) const;
  /// The constraint modes, Psi_s of eq. 8 with its unit rows: the static shapes for a unit displacement of each
  /// contact dof while the other contact dofs are held and no load acts elsewhere; independent x contact dofs. Not of
  /// held faces.
  Eigen::MatrixXcd constraint_modes() const;
  const CyclicTransformation& transform() const { return transform_; }

 private:
  /// Dofs of the low face that move.
  Eigen::Index moving_face() const { return transform_.holds_faces() ? 0 : transform_.dofs().face; }
  void find_segment_modes();
  Eigen::MatrixXcd segment_displacements(const Eigen::MatrixXcd& shapes) const;
  Eigen::MatrixXcd solve_block(const Eigen::MatrixXcd& load, ContactNodes contact) const;

  const SectorFactor& factor_;
  CyclicTransformation transform_;
  Eigen::MatrixXcd
      cholesky_;  ///< L of S_n = T^H S T, moving low | contact; its leading block is that of fixed contact nodes
  Eigen::MatrixXcd segment_modes_;  ///< Psi; independent x contact dofs, empty with contact nodes
};

}  // namespace tiprub::reduce
