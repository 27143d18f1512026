// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "simulate/march/rotor_at_speed.h"
#include "simulate/march/time_march.h"
#include "simulate/response/response.h"

namespace tiprub {

/// [1] condition number of W over the contact nodes. One eigenproblem of their number.
double compliance_condition(const TimeMarch& march);

/// Factor per revolution by which a disturbance of the nodal diameters that symmetry left out grows. The whole wheel
/// is marched on from the settled motion for `revolutions`, the others seeded with 1e-8 of it; the factor is fitted
/// to the second half (least squares through the logarithms). Without a seed nothing would show for hundreds of
/// revolutions. Costs N/(N/g) times as much a revolution as the march of the symmetric part, and more for the larger
/// contact problem. Raises RunError if the contact problem of the whole wheel does.
double excluded_growth(const TimeMarch& settled, const RotorAtSpeed& rotor, const Casing& casing,
                       const ContactLine& contact, int revolutions);

/// Above this factor a disturbance counts as growing.
constexpr double growth_limit = 1 + 1e-3;

/// Relative difference of two responses of one speed and one grid of samples: of the motion if both are settled with
/// the same period (at the best shift by whole revolutions), of the rms amplitudes of engine orders 0 .. 60 if not:
/// irregular trajectories mean nothing, their spectra do.
struct ResponseDifference {
  double value = 0;     ///< [1] of the larger norm: 1 if one of them rests
  const char* measure;  ///< "motion" or "spectrum"
};
ResponseDifference difference(const SpeedResponse& here, const SpeedResponse& there);

}  // namespace tiprub
