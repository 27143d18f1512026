// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/sector_factor.h"

#include <utility>

#include "reduce/operators/cholmod_factor.h"
#include "reduce/operators/mumps_factor.h"

namespace tiprub::reduce {

namespace {

std::unique_ptr<FactorEngine> factorize(const SymmetricMatrix& stiffness, const SectorDofs& dofs,
                                        const FactorChoice& choice) {
  if (choice.method == FactorMethod::cholmod) return factorize_by_cholmod(stiffness, dofs);
  const FactorPlace place = choice.method == FactorMethod::mumps ? FactorPlace::memory : FactorPlace::disk;
  return factorize_by_mumps(stiffness, dofs, place, choice.scratch_folder);
}

}  // namespace

SectorFactor::SectorFactor(const SymmetricMatrix& stiffness, const SectorDofs& dofs, const FactorChoice& choice)
    : engine_(factorize(stiffness, dofs, choice)), schur_(engine_->take_schur_complement()) {}

Eigen::MatrixXd SectorFactor::back_substitute(Eliminated&& eliminated, const Eigen::MatrixXd& interface) const {
  return engine_->back_substitute(std::move(eliminated), interface);
}

}  // namespace tiprub::reduce
