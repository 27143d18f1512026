// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/march/time_march.h"
#include "simulate/response/response.h"

namespace tiprub {

/// [1] condition number of W over the contact nodes. One eigenproblem of their number.
double compliance_condition(const TimeMarch& march);

/// Relative difference of two responses of one speed and one grid of samples: of the motion if both are settled with
/// the same period (at the best shift by beats of the casing: each is a motion of the same scene), of the rms
/// amplitudes of engine orders 0 .. 60 if not: trajectories that never repeat mean nothing, their spectra do.
struct ResponseDifference {
  double value = 0;     ///< [1] of the larger norm: 1 if one of them rests
  const char* measure;  ///< "motion" or "spectrum"
};
ResponseDifference difference(const SpeedResponse& here, const SpeedResponse& there, int lobes);

}  // namespace tiprub
