// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>

#include "simulate/orbits/excluded_growth.h"
#include "simulate/periodic/linear_map.h"

namespace tiprub {

/// A Floquet multiplier: what becomes of a small disturbance in one map.
struct Multiplier {
  std::complex<double> value;
  double uncertainty = 0;  ///< [1] by what its magnitude changed last, while it was sought
};

/// The multiplier of largest magnitude of a linear map of vectors of `size` numbers, by Anasazi's block Krylov-Schur
/// method (Stewart 2001; of few numbers by the matrix itself), until its magnitude stands to `tolerance` of itself.
/// Takes some sixty maps where slow modes are many; where it doesn't come to stand in some hundreds, its uncertainty
/// says so.
Multiplier largest_multiplier(const LinearMap& map, Eigen::Index size, double tolerance = 2e-4);

/// The same as a growth per revolution, of so many maps.
Growth per_revolution(const Multiplier& multiplier, double maps);

}  // namespace tiprub
