// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "reduce/operators/factor_engine.h"
#include "reduce/sector/rotating_elasticity.h"

namespace tiprub::reduce {

/// P K P' = L L' in memory, a supernodal Cholesky factorization (CHOLMOD; Chen, Davis, Hager, Rajamanickam 2008) in
/// which the interface comes last. Then L_FF L_FF' is the Schur complement.
///
/// The K of a sector with free cut faces may be indefinite at speed: a multiple of the identity is therefore added
/// to K_FF before the factorization, and subtracted from S afterwards. Raises RunError.
std::unique_ptr<FactorEngine> factorize_by_cholmod(const SymmetricMatrix& stiffness, const SectorDofs& dofs);

/// Raises RunError if CHOLMOD ended with this status without a factor: for lack of memory, or because numbers of
/// entries exceed what it or the BLAS can count.
void require_factor(int status, Eigen::Index dofs);

}  // namespace tiprub::reduce
