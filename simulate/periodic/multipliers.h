// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>

#include "simulate/orbits/excluded_growth.h"
#include "simulate/periodic/periodic_map.h"

namespace tiprub::simulate {

/// A Floquet multiplier: the factor by which a small disturbance grows in one map.
struct Multiplier {
  std::complex<double> value;
  double uncertainty = 0;  ///< [1] the last change of its magnitude during the iteration
};

/// The multiplier of largest magnitude of a linear map of vectors of `size` numbers. Anasazi's block Krylov-Schur
/// method (Stewart 2001) computes it, or the eigenvalues of the whole matrix if `size` is small. The iteration stops
/// when the magnitude changes by less than `tolerance` of itself. If there are many slow modes, this takes about
/// sixty maps. After 200 maps it stops in any case, and the uncertainty shows that it has not converged.
Multiplier largest_multiplier(const LinearMap& map, Eigen::Index size, double tolerance = 2e-4);

/// The growth per revolution, which consists of `maps` maps.
Growth per_revolution(const Multiplier& multiplier, double maps);

}  // namespace tiprub::simulate
