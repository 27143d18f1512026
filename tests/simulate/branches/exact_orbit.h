// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "tests/simulate/branches/one_sided_spring.h"

namespace tiprub::simulate::testing {

/// An orbit of OneSidedSpring that repeats itself every revolution, to rounding: its motion is a sum of exponentials
/// and sines between the instants at which the second spring is met and left, and these are found by bisection.
struct ExactOrbit {
  double speed = 0;       ///< [rad/s]
  Eigen::Vector2d start;  ///< [m], [m/s] when the casing's crest is at the spring
  double multiplier = 0;  ///< [1] the larger magnitude of the two, a revolution
  double amplitude = 0;   ///< [m] half of the peak-to-peak displacement of the spring's free end, of even samples
};

/// Newton's method from `start`. Empty speed (0) if it finds none.
ExactOrbit exact_orbit(const OneSidedSpring& plan, double speed, const Eigen::Vector2d& start, int samples);

/// [rad/s] ascending: where the orbits from `low` on turn back in speed, up to `high`; by arc length, then by the
/// determinant of 1 less the monodromy matrix, to 1e-9.
std::vector<double> exact_folds(const OneSidedSpring& plan, double low, double high);

}  // namespace tiprub::simulate::testing
