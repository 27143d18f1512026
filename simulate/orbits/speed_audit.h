// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"

namespace tiprub {

/// [1] condition number of W over the contact nodes. One eigenproblem of their number.
double compliance_condition(const TimeMarch& march);

/// What two motions of one speed are compared by; refers to the displacement.
struct SampledMotion {
  const Eigen::MatrixXd& displacement;  ///< [m] samples x channels
  int samples_per_revolution;
  int recorded_revolutions;
  int period_revolutions;  ///< 0: not settled
};

/// Relative difference of two motions of one speed and one grid of samples: of the motion if both are settled with
/// the same period (at the best shift by beats of the casing: each is a motion of the same scene), of the rms
/// amplitudes of engine orders 0 .. 60 if not: trajectories that never repeat mean nothing, their spectra do.
struct MotionDifference {
  double value = 0;  ///< [1] of the larger norm: 1 if one of them rests
  MotionMeasure measure = MotionMeasure::motion;
};
MotionDifference difference(const SampledMotion& here, const SampledMotion& there, int lobes);

}  // namespace tiprub
