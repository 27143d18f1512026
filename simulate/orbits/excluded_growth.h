// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"

namespace tiprub::simulate {

/// The growth of a small disturbance.
struct Growth {
  double factor = 0;       ///< [1] per revolution
  double uncertainty = 0;  ///< [1] of the factor
};

/// The growth of a small disturbance of the nodal diameters that symmetry leaves out. The whole wheel is marched on
/// from the settled motion with these nodal diameters at 1e-8 of it; without a seed they would stay invisible for
/// hundreds of revolutions. After each period their state is scaled back to that size, before it can be lost in
/// rounding or change the contact.
///
/// With a `period` (whole revolutions) the states are images of one linear map. The factor is then its largest
/// multiplier, found by Arnoldi's method, because a decaying disturbance can hide a growing one for tens of
/// revolutions; the uncertainty is the residual. Without a period (0) the factor is the mean growth over the second
/// half of the revolutions, and the uncertainty is twice its standard error.
///
/// Marches at most `revolutions`, and fewer if the residual becomes small or is small against the distance of the
/// factor from 1. A revolution costs g times that of the symmetric march, and more for the larger contact problem.
/// Raises NoMotion if the contact problem of the whole wheel has no solution.
Growth excluded_growth(const TimeMarch& settled, int period, int revolutions);

/// `breaking` or `holds` if the factor differs from 1 by more than its uncertainty and by more than a thousandth;
/// otherwise `undecided`.
SymmetryVerdict judge(const Growth& growth);
/// The same along a motion of this period [revolutions]. Without one (0) it is `undecided` in place of `holds`,
/// because a mean growth over some revolutions proves no decay.
SymmetryVerdict judge(const Growth& growth, int period);

}  // namespace tiprub::simulate
