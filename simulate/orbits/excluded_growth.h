// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"

namespace tiprub {

/// How a small disturbance of the nodal diameters that symmetry left out grows.
struct Growth {
  double factor = 0;       ///< [1] per revolution, in the long run
  double uncertainty = 0;  ///< [1] of it
};

/// The whole wheel is marched on from the settled motion, the nodal diameters left out at 1e-8 of it: without a seed
/// nothing would show for hundreds of revolutions. Each period their state is made small again, before it meets
/// rounding, or contact that it changes.
/// With a `period` (whole revolutions) the states are those of one linear map, and the factor is its largest
/// multiplier, by Arnoldi's method: a decaying disturbance hides a growing one for tens of revolutions, the
/// multipliers of its Krylov space don't. The uncertainty is the residual. Without a period (0) it is the mean over
/// the second half, with twice its standard error.
/// At most `revolutions`; fewer if the residual is small, or small beside the factor's distance from 1. Costs N/(N/g)
/// times as much a revolution as the march of the symmetric part, and more for the larger contact problem. Raises
/// NoMotion if the contact problem of the whole wheel does.
Growth excluded_growth(const TimeMarch& settled, int period, int revolutions);

/// Growing or dying out by more than the uncertainty, and by more than a thousandth a revolution; else undecided.
SymmetryVerdict judge(const Growth& growth);

}  // namespace tiprub
