// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"

namespace tiprub::simulate::testing {

/// One mass on a spring before an oscillating stop w(t) = c - a cos(Omega t) that it meets once a revolution, without
/// rebound, while the stop draws away: it takes the stop's velocity and leaves at once.
struct ReboundingMass {
  double frequency = 1000;  ///< [rad/s] of the mass
  double damping = 0.02;    ///< [1]
  double amplitude = 1e-3;  ///< [m] a
  double clearance = 2e-4;  ///< [m] c
};

/// An orbit of it in closed form. With the displacement s A + v B a revolution after an impact at the displacement s
/// and the velocity v, the phase theta of the impact solves
///   (A - 1) w + B w' = 0,   w = c - a cos(theta),   w' = a Omega sin(theta).
/// There are two solutions, until they meet in a fold where (c/a)^2 = 1 + (Omega B/(A - 1))^2.
struct ReboundingOrbit {
  ReboundingMass mass;
  double speed;       ///< [rad/s] Omega
  double leaves;      ///< [s] the instant of the impact
  double multiplier;  ///< [1] the derivative of the next instant of impact by this one
  double force;       ///< [N/kg] that would hold the mass on the stop after the impact; negative: it leaves at once

  /// [m], [m/s] of the mass, any number of revolutions later.
  double displacement(double t) const;
  double velocity(double t) const;
  /// [m] half of the peak-to-peak displacement, of so many samples.
  double swing(int samples) const;
};

/// The orbit with the smaller multiplier of those that leave at once, or the other one. `speed` must be one that has
/// them.
enum class Half { attracting, repelling };
ReboundingOrbit rebounding_orbit(const ReboundingMass& mass, double speed, Half half);

/// [rad/s] the fold between two speeds, of which the first has orbits.
double rebounding_fold(const ReboundingMass& mass, double low, double high);

/// A model of one mass that moves along the stop only: nothing moves across it, and what does dies out.
ReducedModel one_mass_along_the_stop(double frequency);

}  // namespace tiprub::simulate::testing
