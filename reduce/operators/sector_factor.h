// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <utility>

#include "reduce/operators/factor_engine.h"

namespace tiprub::reduce {

/// One real factorization of the sector's stiffness that serves all nodal diameters.
///
/// With I the interior and F the interface dofs (both cut faces and the contact nodes), a sparse factorization of K
/// in which the interface comes last leaves the Schur complement S = K_FF - K_FI K_II^-1 K_IF. A nodal diameter
/// couples interface dofs only, so what depends on it is a small dense matrix made from S (see cyclic_solver.h). A
/// factorization for each of six nodal diameters would cost five times as much and give the same digits.
///
/// If K_II is indefinite, the rotor is unstable.
class SectorFactor {
 public:
  /// Raises RunError if the interior is not positive definite, or if memory or disk don't suffice.
  SectorFactor(const SymmetricMatrix& stiffness, const SectorDofs& dofs, const FactorChoice& choice = {})
      : engine_(choice.method == FactorMethod::cholmod ? factorize_by_cholmod(stiffness, dofs)
                                                       : factorize_by_mumps(stiffness, dofs, choice)),
        schur_(engine_->take_schur_complement()) {}

  /// S [N/m], symmetric; interface x interface, in the order of SectorDofs.
  const StoredMatrix& schur_complement() const { return schur_; }

  /// First half of a solve: from a load on the interior (rows 0 .. interior-1 of `interior_load`), the load that
  /// reaches the interface, -K_FI K_II^-1 b_I, and what back_substitute() needs of it. With MUMPS other threads wait
  /// from here on until the second half is done.
  Eliminated eliminate(const Eigen::MatrixXd& interior_load) const { return engine_->eliminate(interior_load); }
  /// The same without a load.
  Eliminated unloaded(Eigen::Index columns) const { return engine_->unloaded(columns); }
  /// Second half: the displacement of the sector when its interface moves by `interface` (interface x columns);
  /// sector x columns, in the order of SectorDofs.
  Eigen::MatrixXd back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& interface) const {
    return engine_->back_substitute(std::move(eliminated), interface);
  }

 private:
  std::unique_ptr<FactorEngine> engine_;
  StoredMatrix schur_;
};

}  // namespace tiprub::reduce
