// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/cyclic_modes.h"

namespace tiprub {

/// Modes at a speed, followed from good guesses (independent x at least `count`, lowest first) with the factor of
/// another speed as preconditioner: generalized Davidson (Morgan and Scott 1986) without restart. Each step solves
/// once a wanted mode and adds that to a Rayleigh-Ritz basis; so frequencies only come down, and the change of the
/// last step is more than what is left. Stops when no 1/omega^2 changes by more than `tolerance`; `residual` holds
/// that change. What the guesses don't contain at all can't be found: solve one speed from scratch (lowest_modes())
/// beside it. Raises RunError if it doesn't converge, or if the stiffness is not positive definite on the basis.
CyclicModes follow_modes(const CyclicStiffness& nearby, const SymmetricMatrix& stiffness, const SymmetricMatrix& mass,
                         const Eigen::MatrixXcd& guesses, int count, double tolerance);

}  // namespace tiprub
