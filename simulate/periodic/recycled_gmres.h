// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "simulate/periodic/linear_map.h"

namespace tiprub {

/// Solves (1 - A) x = f for one operator A after another that differ little: GMRES (Saad, Schultz 1986),
/// preconditioned by what all former solves have met. With an orthonormal basis S of their directions and T = (1 - A)
/// S,
///   P = 1 + S ((S^T T)^-1 - 1) S^T
/// takes out what S holds: of a march the slow modes, which are many and alike, so that GMRES alone would take a step
/// for each, each time.
///
/// Belos has GMRES and recycling (GCRO-DR), on vectors of Epetra or Tpetra, whose libraries take 40 ms to load, four
/// times what the rest of the program takes.
class RecycledGmres {
 public:
  /// x with |f - (1 - A) x| <= tolerance |f|, or the best of `most_steps`. One A a step.
  Eigen::VectorXd solve(const LinearMap& A, const Eigen::VectorXd& f, double tolerance);
  /// A in all solves so far.
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

}  // namespace tiprub
