// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <functional>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"

namespace tiprub::simulate {

/// The growth of a small disturbance.
struct Growth {
  double factor = 0;       ///< [1] per revolution
  double uncertainty = 0;  ///< [1] of the factor
};

/// A pseudo-random disturbance of length 1, always the same, of the waves of a march from `first_wave` on, in the
/// order of EnergyState. Lower modes have more weight than higher ones.
Eigen::VectorXd seeded_disturbance(const TimeMarch& march, std::size_t first_wave);

/// The growth along a motion whose disturbances are images of one linear map, `maps` times a revolution: the map's
/// largest multiplier. It is found by Arnoldi's method from `seed`, because a decaying disturbance can hide a growing
/// one for tens of revolutions; the uncertainty is the residual. Applies the map at most `most` times, and fewer
/// times if the residual becomes small or is small against the distance of the factor from 1.
Growth largest_growth(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& map, const Eigen::VectorXd& seed,
                      int most, double maps);

/// The growth of a small disturbance of the nodal diameters that symmetry leaves out. The whole wheel is marched on
/// from the settled motion with these nodal diameters at 1e-8 of it; without a seed they would stay invisible for
/// hundreds of revolutions. After each period their state is scaled back to that size, before it can be lost in
/// rounding or change the contact.
///
/// With penalty, Moreau-Jean and the paper's rule, contacts that switch within a step disturb the motion in each
/// revolution by up to some percent of its energy norm, which is no growth. If a disturbance grows with these, it is
/// followed from a tenth of the motion as well, and this factor counts if it is clearly smaller.
///
/// With a `period` (whole revolutions) the factor is largest_growth() of this map. Without a period (0) it is the
/// mean growth over the second half of the revolutions, with the 95 % uncertainty of a mean of four parts.
///
/// Marches at most `revolutions` from each size. A revolution costs g times that of the symmetric march, and more for
/// the larger contact problem. Raises NoMotion if the contact problem of the whole wheel has no solution.
Growth excluded_growth(const TimeMarch& settled, int period, int revolutions);

/// `breaking` or `holds` if the factor differs from 1 by more than its uncertainty and by more than a thousandth;
/// otherwise `undecided`. Along a motion without `period` [revolutions] it is never `holds`, because a mean growth
/// over some revolutions proves no decay.
SymmetryVerdict judge(const Growth& growth, int period = 1);

}  // namespace tiprub::simulate
