// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "simulate/periodic/periodic_map.h"

namespace tiprub::simulate {

/// Solves (1 - A) x = f for a sequence of operators A that differ little, by GMRES (Saad, Schultz 1986) with a
/// preconditioner from all former solves. With an orthonormal basis S of their directions and T = (1 - A) S,
///   P = 1 + S ((S^T T)^-1 - 1) S^T
/// is the exact inverse on the space of S. For a march that space holds the slow modes; they are many and have nearly
/// equal multipliers, and GMRES without recycling would need a step for each of them in every solve.
///
/// Belos offers recycling (GCRO-DR) on vectors of Epetra or Tpetra only. Their libraries take 40 ms to load, four
/// times as long as the rest of the program.
class RecycledGmres {
 public:
  /// Returns x with |f - (1 - A) x| <= tolerance |f|, or the best after `most_steps`. A step costs one product with
  /// A.
  Eigen::VectorXd solve(const LinearMap& A, const Eigen::VectorXd& f, double tolerance);
  /// Products with A in all solves so far.
  int steps() const { return steps_; }

 private:
  struct Krylov;
  Krylov build(const LinearMap& A, const Eigen::VectorXd& f, double tolerance, int most);
  Eigen::VectorXd precondition(const Eigen::VectorXd& change) const;
  void keep(const Krylov& space);

  Eigen::MatrixXd directions_, images_;  ///< S, T; empty: none
  Eigen::MatrixXd share_;                ///< (S^T T)^-1 - 1
  int steps_ = 0;
};

}  // namespace tiprub::simulate
