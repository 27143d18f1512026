// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "simulate/march/rotor_at_speed.h"
#include "simulate/motion/scene_choices.h"

namespace tiprub::simulate::testing {

/// A scheme at a step: what its equations say of a small motion, and what the march makes of it, which refuses
/// nothing (tiprub-simulate does, before it marches). Rates are natural logarithms of the factor a step; negative: it
/// decays.
struct GrowthPoint {
  std::string scheme;
  double over_limit;  ///< [1] the step over the largest stable one; h omega_max / 2 where there is none
  double predicted, measured;
};

/// What a scheme is run with.
struct GrowthSetup {
  Scheme scheme;
  double damping_ratio;  ///< [1] of critical
  double theta = 0.5;    ///< [1] of Moreau-Jean
  double springs = 0;    ///< [1] of penalty, in tip stiffnesses; every node rests on its spring
};

/// ln of the spectral radius of one step, from the scheme's equations of motion as textbooks print them, not from the
/// march's coefficients: central differences on M, D, K + kappa C C^T, and the theta method on positions and
/// velocities; the exact decay for the trigonometric scheme.
double predicted_rate(const RotorAtSpeed& rotor, const GrowthSetup& setup, double step);

/// A made-up wheel of six sectors, in the air or pressed all around, at several steps to both sides of the limit.
std::vector<GrowthPoint> growth_of(const std::string& name, const GrowthSetup& setup);

/// Every scheme; a table to stdout.
void print_growth();

}  // namespace tiprub::simulate::testing
