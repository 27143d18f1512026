// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "simulate/orbits/anderson.h"
#include "simulate/orbits/speed_audit.h"
#include "simulate/orbits/symmetric_map.h"
#include "simulate/speed/settled_march.h"
#include "simulate/speed/speed_run.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub {
namespace {

using Outcome = AccelerationReport::Outcome;

/// x -> D x + b, D diagonal.
FixedPoint solve_linear(const Eigen::VectorXd& factors, int depth) {
  const Eigen::VectorXd shift = Eigen::VectorXd::LinSpaced(factors.size(), 1, 2);
  return find_fixed_point([&](const Eigen::VectorXd& x) { return Eigen::VectorXd(factors.cwiseProduct(x) + shift); },
                          Eigen::VectorXd::Zero(factors.size()), {1e-11, 200, depth, 4, 1e3, 100});
}

TEST(Anderson, SolvesALinearMapInAsManyStepsAsItHasFactors) {
  const Eigen::VectorXd factors = Eigen::VectorXd::LinSpaced(8, 0.5, 0.99);
  const FixedPoint found = solve_linear(factors, 10);
  ASSERT_EQ(found.reached, FixedPoint::Reached::yes);
  EXPECT_LE(found.evaluations, 12);  // plain iteration: ln(1e-11)/ln(0.99) = 2520
  for (Eigen::Index i = 0; i < factors.size(); ++i) {
    const double exact = (1.0 + static_cast<double>(i) / 7) / (1 - factors[i]);
    EXPECT_NEAR(found.x[i] / exact, 1, 1e-8);
  }
}

TEST(Anderson, FindsFixedPointsThatRepel) {
  EXPECT_EQ(solve_linear(Eigen::VectorXd::LinSpaced(4, 0.5, 1.3), 10).reached, FixedPoint::Reached::yes);
}

TEST(Anderson, GivesUpWhereThereIsNothingToFind) {
  int calls = 0;
  const auto turn = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    ++calls;
    return (10.0 * x.array().sin() + 100 * calls).matrix();
  };
  const FixedPoint found = find_fixed_point(turn, Eigen::VectorXd::Ones(3), {1e-8, 50, 5, 2, 3, 20});
  EXPECT_EQ(found.reached, FixedPoint::Reached::no);
  EXPECT_EQ(found.evaluations, calls);
  EXPECT_LE(calls, 50);
  const auto nowhere = [](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return x * std::numeric_limits<double>::quiet_NaN();
  };
  EXPECT_EQ(find_fixed_point(nowhere, Eigen::VectorXd::Ones(3), {1e-8, 50, 5, 2, 3, 20}).evaluations, 3);
}

TEST(SymmetricMap, ShiftsToTheSectorThatMeetsTheSameCasing) {
  for (int sectors : {1, 2, 5, 6, 10, 13})
    for (int lobes : {1, 2, 3, 4, 5, 10}) {
      const double step = 1.0 / std::lcm(sectors, lobes);  // of a revolution
      const double lobe = 1.0 / lobes;
      const double apart = static_cast<double>(sector_shift(sectors, lobes)) / sectors - step;
      EXPECT_NEAR(apart, lobe * std::round(apart / lobe), 1e-12) << sectors << " sectors, " << lobes << " lobes";
    }
}

TEST(SymmetricMap, ReturnsTheSettledMotion) {
  const ReducedModel model = testing::synthetic_wheel({5, 2, 4});
  const Casing casing = testing::lobed_casing(3, 2e-4, 1e-4);
  testing::Bench bench =
      testing::make_bench(model, casing, 2000, 0.02, {Scheme::trigonometric, ContactRule::complementarity, 1200, 1});
  for (int i = 0; i < 60 * 1200; ++i) bench.march.step();
  SymmetricMap map(bench.march, casing.lobes);
  const Eigen::VectorXd state = map.state();
  EXPECT_EQ(map.maps_per_revolution(), 15);
  EXPECT_LT((map(state) - state).norm(), 1e-7 * state.norm());
  EXPECT_EQ(bench.march.step_count(), 60 * 1200) << "the clock stands still";
}

SpeedResponse run(const ReducedModel& model, const Casing& casing, double speed, Acceleration acceleration) {
  SimulateParameters parameters;
  parameters.damping = {0.005};
  parameters.samples_per_revolution = 120;
  parameters.recorded_revolutions = 2;
  parameters.min_revolutions = 10;
  parameters.max_revolutions = 80;
  parameters.settle_tolerance = 1e-5;
  parameters.casing_areas = 1;
  parameters.acceleration = acceleration;
  parameters.steps_per_period = 400;
  const SceneScope scope = find_scope(model.sector_count, casing.lobes, parameters);
  const Scene scene{model, casing, parameters, scope};
  parameters.steps_per_revolution =  // one step for all: two motions are compared
      steps_per_revolution(scope, parameters, rotor_of(scene, speed).first_frequency, speed);
  return simulate_speed(scene, speed).response;
}

TEST(Acceleration, ComesToTheMotionOfPlainMarchingInFewerRevolutions) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  const Casing casing = testing::lobed_casing(2, 2e-4, 1e-4);
  const SpeedResponse plain = run(model, casing, 2000, Acceleration::none);
  const SpeedResponse fast = run(model, casing, 2000, Acceleration::anderson);
  ASSERT_EQ(plain.motion, MotionClass::periodic);
  ASSERT_EQ(fast.motion, MotionClass::periodic);
  EXPECT_EQ(plain.audit.acceleration.outcome, Outcome::none);
  EXPECT_EQ(fast.audit.acceleration.outcome, Outcome::settled);
  EXPECT_GT(fast.audit.acceleration.revolutions, 0);
  EXPECT_LT(fast.revolutions, 0.75 * plain.revolutions);
  EXPECT_LT(difference(fast, plain, casing.lobes).value, 2e-5);  // each is within settle_tolerance of the motion
}

/// At 2500 rad/s the motion repeats every few revolutions, beside an unstable orbit of one; with one lobe at 2000
/// rad/s it never does, by a little. There is nothing to jump to, and the answer is that of marching, bit by bit.
TEST(Acceleration, FallsBackOnMarchingWhereNoSteadyOrbitIs) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  for (const auto& [lobes, speed] : {std::pair(2, 2500.0), std::pair(1, 2000.0)}) {
    const Casing casing = testing::lobed_casing(lobes, 2e-4, 1e-4);
    const SpeedResponse plain = run(model, casing, speed, Acceleration::none);
    const SpeedResponse tried = run(model, casing, speed, Acceleration::anderson);
    EXPECT_EQ(plain.period_revolutions, lobes == 2 ? 5 : 0);
    EXPECT_EQ(tried.period_revolutions, plain.period_revolutions);
    EXPECT_EQ(tried.audit.acceleration.outcome, Outcome::fell_back);
    EXPECT_EQ(tried.displacement, plain.displacement);
    EXPECT_EQ(tried.contact_force, plain.contact_force);
    EXPECT_EQ(tried.revolutions, plain.revolutions + tried.audit.acceleration.revolutions);
  }
}

}  // namespace
}  // namespace tiprub
