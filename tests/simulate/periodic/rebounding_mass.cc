// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulate/periodic/rebounding_mass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/simulate/one_sector.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// Displacement and velocity a while after a start with a displacement or a velocity of one.
struct Flight {
  double s, v;          ///< displacement
  double s_dot, v_dot;  ///< velocity
};

Flight flight(const ReboundingMass& mass, double t) {
  const double decay = mass.damping * mass.frequency;
  const double damped = mass.frequency * std::sqrt(1 - mass.damping * mass.damping);
  const double e = std::exp(-decay * t), cosine = e * std::cos(damped * t), sine = e * std::sin(damped * t) / damped;
  return {cosine + decay * sine, sine, -mass.frequency * mass.frequency * sine, cosine - decay * sine};
}

/// (A - 1, Omega B).
struct Closing {
  double a, b;
};
Closing closing(const ReboundingMass& mass, double speed) {
  const Flight turn = flight(mass, two_pi / speed);
  return {turn.s - 1, speed * turn.v};
}

double stop(const ReboundingMass& mass, double phase) {
  return mass.clearance - mass.amplitude * std::cos(phase);
}

/// cos(theta + psi), whose magnitude is 1 at the fold.
double cosine_of_phase(const ReboundingMass& mass, double speed) {
  const auto [a, b] = closing(mass, speed);
  return a * mass.clearance / (mass.amplitude * std::hypot(a, b));
}

ReboundingOrbit at_phase(const ReboundingMass& mass, double speed, double phase) {
  const double w = stop(mass, phase), dw = mass.amplitude * speed * std::sin(phase),
               ddw = mass.amplitude * speed * speed * std::cos(phase);
  const Flight turn = flight(mass, two_pi / speed);
  // the gap a revolution later, w(t) - u(t; t_0), by t and by t_0, at which the flight starts
  const double by_t = dw - (w * turn.s_dot + dw * turn.v_dot);
  const double by_start = w * turn.s_dot + dw * turn.v_dot - (dw * turn.s + ddw * turn.v);
  const double force = -(ddw + 2 * mass.damping * mass.frequency * dw + mass.frequency * mass.frequency * w);
  return {mass, speed, phase / speed, -by_start / by_t, force};
}

}  // namespace

double ReboundingOrbit::displacement(double t) const {
  const double period = two_pi / speed, since = t - leaves, past = since - std::floor(since / period) * period;
  const Flight now = flight(mass, past);
  return stop(mass, speed * leaves) * now.s + mass.amplitude * speed * std::sin(speed * leaves) * now.v;
}

double ReboundingOrbit::velocity(double t) const {
  const double period = two_pi / speed, since = t - leaves, past = since - std::floor(since / period) * period;
  const Flight now = flight(mass, past);
  return stop(mass, speed * leaves) * now.s_dot + mass.amplitude * speed * std::sin(speed * leaves) * now.v_dot;
}

double ReboundingOrbit::swing(int samples) const {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (int i = 0; i < samples; ++i) {
    const double u = displacement(two_pi / speed * i / samples);
    low = std::min(low, u);
    high = std::max(high, u);
  }
  return (high - low) / 2;
}

ReboundingOrbit rebounding_orbit(const ReboundingMass& mass, double speed, Half half) {
  const auto [a, b] = closing(mass, speed);
  const double psi = std::atan2(b, a), away = std::acos(cosine_of_phase(mass, speed));
  const ReboundingOrbit one = at_phase(mass, speed, away - psi), other = at_phase(mass, speed, -away - psi);
  const bool one_attracts =
      one.force < 0 && !(other.force < 0 && std::abs(other.multiplier) < std::abs(one.multiplier));
  return one_attracts == (half == Half::attracting) ? one : other;
}

double rebounding_fold(const ReboundingMass& mass, double low, double high) {
  while (high - low > 1e-9 * low) {
    const double middle = (low + high) / 2;
    (std::abs(cosine_of_phase(mass, middle)) < 1 ? low : high) = middle;
  }
  return low;
}

ReducedModel one_mass_along_the_stop(double frequency) {
  constexpr double mass = 0.02, stiff = 1e6;
  ReducedModel model = one_sector();
  NodalDiameterModel only;
  only.M = mass * Eigen::MatrixXcd::Identity(3, 3);
  only.K.terms = {frequency * frequency * only.M};
  only.K[0](1, 1) = only.K[0](2, 2) = stiff * only.K[0](0, 0);
  model.nodal_diameters = {only};
  return model;
}

}  // namespace tiprub::simulate::testing
