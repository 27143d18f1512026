// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>

#include "reduce/operators/factor_engine.h"

namespace tiprub::reduce {

/// One real factorization of the sector's stiffness that serves all nodal diameters (reduce/theory.md, section 4).
/// With I the interior and F the interface dofs (both cut faces and the contact nodes), which come last, it leaves
/// the Schur complement S = K_FF - K_FI K_II^-1 K_IF, of which a nodal diameter makes a small dense matrix (see
/// cyclic_solver.h). A factorization for each of six nodal diameters would cost five times as much and give the same
/// digits. If K_II is indefinite, the rotor is unstable.
class SectorFactor {
 public:
  /// Raises RunError if the interior is not positive definite, or if memory or disk don't suffice.
  SectorFactor(const SymmetricMatrix& stiffness, const SectorDofs& dofs, const FactorChoice& choice = {})
      : engine_(choice.method == FactorMethod::cholmod ? factorize_by_cholmod(stiffness, dofs)
                                                       : factorize_by_mumps(stiffness, dofs, choice)),
        schur_(engine_->take_schur_complement()) {}

  /// S [N/m], symmetric; interface x interface, in the order of SectorDofs.
  const StoredMatrix& schur_complement() const { return schur_; }

  /// Both halves of a solve.
  const FactorEngine& engine() const { return *engine_; }

 private:
  std::unique_ptr<FactorEngine> engine_;
  StoredMatrix schur_;
};

}  // namespace tiprub::reduce
