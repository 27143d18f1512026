// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/benchmark/trial.h"
#include "tests/simulate/compared_responses.h"

namespace tiprub::simulate {
namespace {

SpeedResponse settled(const testing::BenchWheel& wheel, double speed, int steps) {
  SimulateParameters parameters = testing::bench_parameters(wheel, {30, 120, 1, 1e-5});
  parameters.steps_per_revolution = steps;
  return testing::run_speed(wheel, parameters, speed);
}

/// Symptom: on a wheel with light tips the default step was off by 6e-2 at a periodic speed, and twice as many steps
/// by 6e-4. Cause: at w h = 2 pi the coefficients of exact flight have no compliance, and the tips' own modes lay
/// there. Right: the default within 5e-3 of an 8 times finer run, and an error that falls with the square of the
/// step.
TEST(AccuracyOfTheDefault, HoldsWhereTipModesTurnAboutOnceAStep) {
  const testing::BenchWheel wheel = testing::made_wheel(2);
  for (const double speed : {850.0, 1000.0, 1300.0}) {
    const SpeedResponse at = settled(wheel, speed, 0);
    const SpeedResponse reference = settled(wheel, speed, 8 * at.steps_per_revolution);
    ASSERT_EQ(reference.failure, "");
    ASSERT_EQ(reference.motion, MotionClass::periodic) << speed;
    const MotionDifference error = testing::difference(at, reference, wheel.casing.lobes);
    EXPECT_EQ(error.measure, MotionMeasure::motion);
    EXPECT_LT(error.value, 5e-3) << speed;
    const double halved =
        testing::difference(settled(wheel, speed, 2 * at.steps_per_revolution), reference, wheel.casing.lobes).value;
    EXPECT_LT(halved, 0.45 * error.value) << speed;
    EXPECT_GE(static_cast<double>(at.contact_steps), 0.7 * at.steps_per_revolution) << "a run with little contact";
  }
}

testing::Trial trial(const testing::BenchWheel& wheel, int steps) {
  testing::Trial trial{wheel, testing::bench_parameters(wheel, testing::patience)};
  trial.parameters.resolved_frequency = 7200;
  trial.parameters.steps_per_revolution = steps;
  return trial;
}

/// Symptom: of a motion without period, every step was 20 % off. Cause: its spectrum over few revolutions, which no
/// two marches share. Right: the statistics of many revolutions, which the step hardly changes.
TEST(AccuracyOfTheDefault, OfAMotionWithoutPeriodIsThatOfItsStatistics) {
  testing::BenchWheel wheel = testing::made_wheel(2);
  wheel.damping = 0.0005;
  testing::Reference reference;
  const testing::Verdict verdict = testing::try_out(trial(wheel, 3840), reference);
  ASSERT_TRUE(reference);
  EXPECT_FALSE(repeats(reference->motion));
  EXPECT_EQ(verdict.outcome, testing::Outcome::stable) << verdict.number;
}

}  // namespace
}  // namespace tiprub::simulate
