// SPDX-License-Identifier: GPL-3.0-or-later
// How a scheme fails beyond its limit: the rate that its equations foretell, and the march's.
#include "tests/benchmark/growth.h"

#include <gtest/gtest.h>

#include "simulate/march/time_march.h"
#include "tests/benchmark/bench_wheel.h"
#include "tests/benchmark/whole_rotor.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::testing {
namespace {

constexpr double asked = 0.05;

/// Grows beyond the limit and decays below it, at the predicted rate.
void expect_limit(const GrowthSetup& setup) {
  for (const GrowthPoint& at : growth_of("", setup)) {
    EXPECT_EQ(at.predicted > 0, at.over_limit > 1) << at.over_limit;
    EXPECT_NEAR(at.measured / at.predicted, 1, asked) << at.over_limit;
  }
}

TEST(GrowthBeyondTheLimit, OfCentralDifferencesIsPredicted) {
  expect_limit({Scheme::central_differences, 0.01});
}

TEST(GrowthBeyondTheLimit, OfPenaltyIsPredictedWithItsSprings) {
  for (const double springs : {10.0, 1000.0}) expect_limit({Scheme::penalty, 0.01, 0.5, springs});
}

TEST(GrowthBeyondTheLimit, OfMoreauJeanBelowOneHalfIsPredicted) {
  for (const double theta : {0.4, 0.48}) expect_limit({Scheme::moreau_jean, 0.01, theta});
}

/// Schemes without a limit decay at every step, as fast as their equations say.
TEST(GrowthBeyondTheLimit, IsNoneOfTheDefaultAndOfMoreauJeanAtOneHalf) {
  for (const Scheme scheme : {Scheme::trigonometric, Scheme::moreau_jean})
    for (const GrowthPoint& at : growth_of("", {scheme, 0.01})) {
      EXPECT_LT(at.predicted, 0) << at.over_limit;
      EXPECT_NEAR(at.measured / at.predicted, 1, asked) << at.over_limit;
    }
}

/// What a step is compared with is the same motion: the whole wheel in its real modes, as one sector.
TEST(WholeRotor, MovesAsItsNodalDiametersDo) {
  constexpr int steps = 2400;
  const BenchWheel wheel = made_wheel(3);
  const RotorAtSpeed rotor = rotor_at_speed(wheel.model, wheel.speed, nodal_diameters(wheel, 1), {wheel.damping});
  const WholeRotor whole = whole_rotor(rotor, wheel.model.contact);
  const MarchSetup setup{Scheme::trigonometric, ContactRule::complementarity, steps, 1};
  const Eigen::VectorXd clearance = wheel.casing.running_clearance(wheel.model.contact, wheel.speed);
  TimeMarch by_waves = march_of(rotor, wheel.casing, wheel.model.contact, clearance, setup);
  TimeMarch at_once =
      march_of(whole.rotor, wheel.casing, whole.contact, clearance.replicate(rotor.sector_count, 1), setup);
  for (int i = 0; i < 2 * steps; ++i) {
    by_waves.step();
    at_once.step();
  }
  ASSERT_FALSE(by_waves.contact().closed().empty());
  const int nodes = by_waves.node_count();
  for (int j = 0; j < by_waves.sectors(); ++j)
    EXPECT_LT((by_waves.displacement().segment(j * by_waves.width(), nodes) -
               at_once.displacement().segment(j * nodes, nodes))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-8 * by_waves.displacement().cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace tiprub::simulate::testing
