// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>

#include "simulate/orbits/excluded_growth.h"
#include "simulate/periodic/periodic_map.h"

namespace tiprub::simulate {

/// A Floquet multiplier: the factor of a small disturbance in one map.
struct Multiplier {
  std::complex<double> value;
  double uncertainty = 0;  ///< [1] the last change of its magnitude during the iteration
};

/// The multiplier of largest magnitude of a linear map of vectors of `size` numbers, by Anasazi's block Krylov-Schur
/// method (Stewart 2001), or by the whole matrix if `size` is small. Stops when the magnitude changes by less than
/// `tolerance` of itself. This takes about sixty maps where there are many slow modes; if it does not converge within
/// 200 maps, the uncertainty tells.
Multiplier largest_multiplier(const LinearMap& map, Eigen::Index size, double tolerance = 2e-4);

/// The same as growth per revolution, which has `maps` maps.
Growth per_revolution(const Multiplier& multiplier, double maps);

}  // namespace tiprub::simulate
