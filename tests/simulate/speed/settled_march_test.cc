// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/settled_march.h"

#include <gtest/gtest.h>

#include "simulate/march/marched_scene.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

/// A wheel in an oval casing at one speed.
struct TurningWheel {
  ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  Casing casing = testing::lobed_casing(2, 2e-4, 1e-4);
  SimulateParameters parameters = testing::settling_parameters();
  SceneScope scope;
  double speed;

  explicit TurningWheel(double turned) : speed(turned) {
    parameters.max_revolutions = 120;
    parameters.step_tolerance = 2e-3;
    scope = find_scope(model.sector_count, casing.lobes, parameters);
  }
  Scene scene() const { return {model, casing, parameters, scope}; }
  SharedRotor rotor() const { return rotor_of(scene(), speed); }
  int planned_steps() const { return steps_per_revolution(scope, parameters, rotor()->first_frequency, speed); }
  RefinedMotion refined() const { return settle_within_tolerance(scene(), rotor(), {}, CycleChoice::left); }
};

/// Transients pass with twice the step, the motion itself is marched with the step asked for or a shorter one.
TEST(SettledMarch, FromRestComesToTheMotionOfAMuchShorterStep) {
  const TurningWheel wheel(2000);
  const RefinedMotion found = wheel.refined();
  ASSERT_TRUE(found.motion.state.settled());
  EXPECT_GE(found.motion.march->steps_per_revolution(), wheel.planned_steps());
  EXPECT_LE(found.step_reached, 1);
  const SettledMotion exact = settle(wheel.scene(), wheel.rotor(), {}, {16 * wheel.planned_steps(), 10});
  const double error = difference(found.motion.sampled(), exact.sampled(), wheel.casing.lobes).value;
  EXPECT_LE(error, wheel.parameters.step_tolerance);
  EXPECT_GT(error, 0);
}

/// Finer steps would tell nothing of a motion that never repeats: its spectrum scatters by more than they change it.
TEST(SettledMarch, TakesTheStepAskedForWhereAMotionDoesNotSettle) {
  TurningWheel wheel(2880);
  const RefinedMotion found = wheel.refined();
  EXPECT_FALSE(found.motion.state.settled());
  EXPECT_GE(found.motion.march->steps_per_revolution(), wheel.planned_steps());
  EXPECT_LT(found.motion.march->steps_per_revolution(), 2 * wheel.planned_steps());
  ASSERT_TRUE(found.halving);
  EXPECT_EQ(found.halving->measure, MotionMeasure::spectrum);
}

/// Symptom: while the casing still grew, tips that it had not reached were said to be settled, without any contact.
TEST(SettledMarch, DoesNotSettleBeforeTheCasingHasGrown) {
  TurningWheel wheel(2000);
  wheel.casing.ramp_revolutions = 60;
  wheel.parameters.min_revolutions = 10;
  const SettledMotion found = settle(wheel.scene(), wheel.rotor(), {}, {wheel.planned_steps(), 10});
  EXPECT_GT(found.revolutions, 60);
  EXPECT_GT(found.recorded.contact_steps, 0);
}

/// Central differences with a step between half of their limit and the limit.
TEST(SettledMarch, BeginsWithTheStepAskedForWhereTwiceAsLongIsBeyondTheLimit) {
  TurningWheel wheel(2000);
  wheel.parameters.scheme = Scheme::central_differences;
  const double omega_max =
      TimeMarch(marched_scene(wheel.scene(), wheel.rotor(), wheel.planned_steps())).scene().omega_max();
  wheel.parameters.steps_per_period = 1.2 * omega_max / (2 * wheel.rotor()->first_frequency);
  const RefinedMotion found = wheel.refined();
  EXPECT_GE(found.motion.march->steps_per_revolution(), wheel.planned_steps());
  EXPECT_LE(found.motion.step_ratio, 1);
}

}  // namespace
}  // namespace tiprub::simulate
