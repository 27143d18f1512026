// SPDX-License-Identifier: GPL-3.0-or-later
// What the motion does: slow settling, coexisting motions, broken symmetry.
#include <gtest/gtest.h>

#include <cmath>

#include "simulate/speed_audit.h"
#include "simulate/steady_state.h"
#include "tests/stability/bench_scene.h"

namespace tiprub {
namespace {

/// A change far below the tolerance, which decays just fast enough, or grows.
SteadyVerdict::Settled judge(double rate) {
  SteadyState state(1e-3, 0.0);
  SteadyVerdict verdict;
  for (int r = 0; r < 60; ++r) {
    Eigen::VectorXd motion = Eigen::VectorXd::LinSpaced(50, -1, 1);
    motion[3] += 1e-4 * std::pow(rate, r);
    state.add(motion);
    verdict = state.judge();
  }
  EXPECT_LT(verdict.change, 1e-3);  // one threshold alone would call both settled
  return verdict.settled;
}

TEST(SettlingLimit, IsTheDecayNotTheChange) {
  EXPECT_EQ(judge(0.97), SteadyVerdict::Settled::yes);
  EXPECT_EQ(judge(1.03), SteadyVerdict::Settled::no);
}

/// A disturbance of the nodal diameters that symmetry leaves out, on a wheel that rubs all around: damping takes it
/// away at the rate of its free decay or faster; negative damping, put there by hand, lets it grow.
double growth(double excluded_damping) {
  const ReducedModel model = testing::synthetic_wheel({});
  const Casing casing = testing::lobed_casing(2, 2e-4, 1.5e-4);
  RotorAtSpeed rotor = rotor_at_speed(model, 900, {0, 2}, {0.01});
  for (WaveModes& wave : rotor.others) wave.damping_ratio.setConstant(excluded_damping);
  TimeMarch march(rotor, casing, model.contact, {Scheme::trigonometric, ContactRule::complementarity, 1200, 2});
  for (int i = 0; i < 30 * 1200; ++i) march.step();
  return excluded_growth(march, rotor, casing, model.contact, 12);
}

TEST(SymmetryLimit, IsTheGrowthOfWhatWasLeftOut) {
  EXPECT_LT(growth(0.01), 1.0);
  EXPECT_GT(growth(-0.05), growth_limit);
}

}  // namespace
}  // namespace tiprub
