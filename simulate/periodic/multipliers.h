// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>

#include "simulate/periodic/linear_map.h"

namespace tiprub {

/// A Floquet multiplier: what becomes of a small disturbance in one map.
struct Multiplier {
  std::complex<double> value;
  double uncertainty = 0;  ///< [1] of its magnitude: |A v - mu v| of its unit vector v is less
};

/// The multiplier of largest magnitude of a linear map of vectors of `size` numbers, by Anasazi's block Krylov-Schur
/// method (Stewart 2001; of few numbers by the matrix itself), to `tolerance` of its magnitude; where that isn't
/// reached, its uncertainty is 1. Takes some eighty maps for a thousandth where slow modes are many.
Multiplier largest_multiplier(const LinearMap& map, Eigen::Index size, double tolerance = 1e-3);

}  // namespace tiprub
