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
  double uncertainty = 0;  ///< [1] the largest of the last three changes of its magnitude in the iteration
};

/// How exactly a multiplier is wanted.
struct MultiplierGoal {
  double tolerance = 2e-4;  ///< [1] of the magnitude
  double clear = 2e-4;    ///< [1] the tolerance if the uncertainty does not tell on which side of 1 the magnitude is
  Eigen::VectorXd start;  ///< of the Krylov space; empty: pseudo-random
};

/// The multiplier of largest magnitude of a linear map of vectors of `size` numbers. Anasazi's block Krylov-Schur
/// method (Stewart 2001) spans the space, or the whole matrix is used if `size` is small. The iteration stops when
/// the magnitude changes by less than the tolerance of itself. If there are many slow modes, this takes about sixty
/// maps. After 200 maps it stops in any case, and the uncertainty shows that it has not converged.
Multiplier largest_multiplier(const LinearMap& map, Eigen::Index size, const MultiplierGoal& goal = {});

/// The growth per revolution, which consists of `maps` maps.
Growth per_revolution(const Multiplier& multiplier, double maps);

}  // namespace tiprub::simulate
