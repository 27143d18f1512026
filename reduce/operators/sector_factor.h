// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>

#include "reduce/sector/rotating_elasticity.h"

namespace tiprub::reduce {

/// One real factorization of the sector's stiffness that serves all nodal diameters.
///
/// With I the interior and F the interface dofs (both cut faces and the contact nodes), P K P' = L L' is a supernodal
/// Cholesky factorization (CHOLMOD; Chen, Davis, Hager, Rajamanickam 2008) in which the interface comes last. Then
/// L_FF L_FF' is the Schur complement S = K_FF - K_FI K_II^-1 K_IF. A nodal diameter couples interface dofs only, so
/// what depends on it is a small dense matrix made from S (see cyclic_solver.h). A factorization for each of six
/// nodal diameters would cost five times as much and give the same digits.
///
/// The K of a sector with free cut faces may be indefinite at speed: a multiple of the identity is therefore added
/// to K_FF before the factorization, and subtracted from S afterwards. If K_II is indefinite, the rotor is
/// unstable.
class SectorFactor {
 public:
  /// Raises RunError if the interior is not positive definite or the memory doesn't suffice.
  SectorFactor(const SymmetricMatrix& stiffness, const SectorDofs& dofs);
  ~SectorFactor();
  SectorFactor(SectorFactor&&) noexcept;

  /// S [N/m], symmetric; interface x interface, in the order of SectorDofs.
  const Eigen::MatrixXd& schur_complement() const { return schur_; }

  /// First half of a solve: from a load on the interior (rows 0 .. interior-1 of `interior_load`), the load that
  /// reaches the interface, -K_FI K_II^-1 b_I, and what back_substitute() needs of it. Columns are load cases.
  struct Eliminated {
    Eigen::MatrixXd state;           ///< sector x columns, in the factor's order
    Eigen::MatrixXd interface_load;  ///< interface x columns
  };
  Eliminated eliminate(const Eigen::MatrixXd& interior_load) const;
  /// Second half: the displacement of the sector when its interface moves by `interface` (interface x columns);
  /// sector x columns, in the order of SectorDofs.
  Eigen::MatrixXd back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& interface) const;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
  Eigen::MatrixXd schur_;
};

/// Raises RunError if CHOLMOD ended with this status without a factor: for lack of memory, or because numbers of
/// entries exceed what it or the BLAS can count.
void require_factor(int status, Eigen::Index dofs);

}  // namespace tiprub::reduce
