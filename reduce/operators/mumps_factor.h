// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "reduce/operators/factor_engine.h"
#include "reduce/sector/rotating_elasticity.h"

namespace tiprub::reduce {

enum class FactorPlace { memory, disk };

/// K_II = L D L' and the Schur complement of the interface by the multifrontal method (MUMPS; Amestoy, Duff, Koster,
/// L'Excellent 2001). The interface itself is not factorized, so that K_FF needs no shift. A factor on disk is
/// written to files in `scratch_folder` as it is made, and each pass of a solve reads them.
///
/// MUMPS and its files hold the state of one solve in variables of the process: eliminate() therefore locks all
/// factors of MUMPS until back_substitute(). Passes cost about 1.5 times CHOLMOD's, as the library sorts and copies
/// right sides; that is why CHOLMOD is taken where its factors fit. Starts MPI if nothing has started it yet.
///
/// Raises RunError if K_II is not positive definite, or if memory or disk don't suffice.
std::unique_ptr<FactorEngine> factorize_by_mumps(const SymmetricMatrix& stiffness, const SectorDofs& dofs,
                                                 FactorPlace place, const std::filesystem::path& scratch_folder);

/// Raises RunError for a return value INFOG(1) of MUMPS, with INFOG(2), that isn't zero or a warning.
void require_mumps(int error, int detail, Eigen::Index dofs);

}  // namespace tiprub::reduce
