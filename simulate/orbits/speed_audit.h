// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"

namespace tiprub::simulate {

/// [1] The condition number of W over the contact nodes. Solves one eigenproblem of that size.
double compliance_condition(const TimeMarch& march);

/// A motion as difference() compares it; refers to the displacement.
struct SampledMotion {
  const Eigen::MatrixXd& displacement;  ///< [m] samples x channels
  int samples_per_revolution;
  int recorded_revolutions;
  int period_revolutions;  ///< 0: not settled
};

/// The relative difference of two motions of one speed on the same grid of samples. If both have settled with the
/// same period, they are compared sample by sample, at the best shift by beats of the casing, because each shift is a
/// motion of the same scene. Otherwise the rms amplitudes of engine orders 0 .. 60 are compared, because trajectories
/// that do not repeat can't be compared themselves.
struct MotionDifference {
  double value = 0;  ///< [1] of the larger norm: 1 if one of the motions is at rest
  MotionMeasure measure = MotionMeasure::motion;
};
MotionDifference difference(const SampledMotion& here, const SampledMotion& there, int lobes);

}  // namespace tiprub::simulate
