// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reduce/model/reduced_model.h"

namespace tiprub::simulate::testing {

/// A mass on a spring, and before it a second spring that a casing of one lobe pushes, and never pulls:
///   m u'' + 2 zeta w m u' + k u = -k_1 max(0, u + a cos(Omega t) - c),   w^2 = k/m.
struct OneSidedSpring {
  double mass = 0.02;          ///< [kg] m
  double stiffness = 2e4;      ///< [N/m] k
  double one_sided = 2e4;      ///< [N/m] k_1
  double damping = 0.01;       ///< [1] zeta
  double amplitude = 1.02e-4;  ///< [m] a
  double clearance = 1e-4;     ///< [m] c
};

/// As a reduced model of one sector: its contact node is the second spring's free end, nearly without mass.
ReducedModel one_sided_spring(const OneSidedSpring& plan);

/// [rad/s] between two speeds, ascending: where its periodic motions turn back in speed, by harmonic balance (the
/// force at many instants) followed along its arc length.
std::vector<double> folds_by_harmonic_balance(const OneSidedSpring& plan, double low, double high);

}  // namespace tiprub::simulate::testing
