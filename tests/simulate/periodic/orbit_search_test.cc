// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "simulate/march/march_state.h"
#include "simulate/march/marched_scene.h"
#include "simulate/orbits/excluded_growth.h"
#include "simulate/periodic/marched_map.h"
#include "simulate/periodic/orbit_search.h"
#include "simulate/speed/settled_march.h"
#include "simulate/speed/speed_run.h"
#include "tests/simulate/compared_responses.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

using Outcome = OrbitReport::Outcome;

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
  MarchedMap map(bench.march);
  const Eigen::VectorXd state = map.symmetric().state();
  EXPECT_EQ(map.symmetric().maps_per_revolution(), 15);
  EXPECT_LT((map.image(state).state - state).norm(), 1e-7 * state.norm());
  EXPECT_EQ(bench.march.step_count(), 60 * 1200) << "the clock stands still";
}

struct Kept {
  int revolutions;
};

/// One step for all: motions are compared.
SimulateParameters parameters_for(const ReducedModel& model, const Casing& casing, double speed) {
  SimulateParameters parameters = testing::settling_parameters();
  parameters.symmetry_check_revolutions = 24;
  const SceneScope scope = find_scope(model.sector_count, casing.lobes, parameters);
  const Scene scene{model, casing, parameters, scope};
  parameters.steps_per_revolution =
      steps_per_revolution(scope, parameters, rotor_of(scene, speed)->first_frequency, speed);
  return parameters;
}

SpeedResponse run(const ReducedModel& model, const Casing& casing, double speed, SteadyStateMethod method,
                  Scheme scheme = Scheme::trigonometric, Kept kept = {2}) {
  SimulateParameters parameters = parameters_for(model, casing, speed);
  parameters.scheme = scheme;
  parameters.recorded_revolutions = kept.revolutions;
  parameters.steady_state = method;
  const SceneScope scope = find_scope(model.sector_count, casing.lobes, parameters);
  return simulate_speed({model, casing, parameters, scope}, speed).response;
}

/// A wheel of six blades in an oval casing, with one step for all motions.
struct OneSpeed {
  ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  Casing casing = testing::lobed_casing(2, 2e-4, 1e-4);
  SimulateParameters parameters;
  SceneScope scope;
  Scene scene{model, casing, parameters, scope};
  SharedRotor rotor;
  MarchPlan plan;

  explicit OneSpeed(double speed)
      : parameters(parameters_for(model, casing, speed)),
        scope(find_scope(model.sector_count, casing.lobes, parameters)),
        rotor(rotor_of(scene, speed)),
        plan{parameters.steps_per_revolution, 10} {}
};

TEST(OrbitSearch, ComesToTheMotionOfPlainMarchingInFewerRevolutions) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  const Casing casing = testing::lobed_casing(2, 2e-4, 1e-4);
  const SpeedResponse plain = run(model, casing, 2000, SteadyStateMethod::march);
  const SpeedResponse fast = run(model, casing, 2000, SteadyStateMethod::orbit);
  ASSERT_EQ(plain.motion, MotionClass::periodic);
  ASSERT_EQ(fast.motion, MotionClass::periodic);
  EXPECT_EQ(plain.audit.orbit.outcome, Outcome::none);
  EXPECT_EQ(fast.audit.orbit.outcome, Outcome::found);
  EXPECT_LT(fast.revolutions, 0.5 * plain.revolutions);
  EXPECT_LT(testing::difference(fast, plain, casing.lobes).value,
            2e-5);  // the march is within settle_tolerance of the motion
  EXPECT_LT(fast.audit.orbit.residual, 1e-6);
  EXPECT_LT(fast.audit.orbit.multiplier, 1);
  EXPECT_GT(fast.audit.orbit.multiplier, 0.5);
}

/// Of what symmetry leaves out, by the linearised march along a settled motion and by a small disturbance of the
/// whole wheel. The last motion repeats after three revolutions: 24 revolutions hold only eight of its maps, which
/// leave the largest uncertainty. The settled march stays as it was.
TEST(OrbitSearch, TellsHowExcludedDisturbancesGrowAsTheirMarchDoes) {
  for (const auto& [speed, period] : {std::pair(1300.0, 1), std::pair(2000.0, 1), std::pair(1660.0, 3)}) {
    const OneSpeed at(speed);
    const SettledMotion settled = settle(at.scene, at.rotor, {}, at.plan);
    ASSERT_EQ(settled.state.period_revolutions, period) << speed;
    const Eigen::VectorXd before = settled.march->displacement();
    const Growth held = excluded_growth_along(*settled.march, period, 24);
    EXPECT_LT((settled.march->displacement() - before).norm(), 1e-12 * before.norm());
    const Growth marched = excluded_growth(*settled.march, period, 24);
    EXPECT_NEAR(held.factor, marched.factor, held.uncertainty + marched.uncertainty) << speed;
    EXPECT_LE(held.uncertainty, std::max(0.2 * std::abs(1 - held.factor), 1e-3)) << speed;
  }
}

/// By marching to the settled motion, and by the search.
TEST(OrbitSearch, JudgesSymmetryAsAfterAMarch) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  const Casing casing = testing::lobed_casing(2, 2e-4, 1e-4);
  for (const double speed : {1300.0, 2000.0}) {
    const SpeedResponse plain = run(model, casing, speed, SteadyStateMethod::march);
    const SpeedResponse fast = run(model, casing, speed, SteadyStateMethod::orbit);
    ASSERT_EQ(fast.audit.orbit.outcome, Outcome::found) << speed;
    EXPECT_NEAR(*fast.audit.excluded_growth, *plain.audit.excluded_growth,
                *plain.audit.excluded_growth_uncertainty + *fast.audit.excluded_growth_uncertainty);
    EXPECT_EQ(fast.audit.symmetry, plain.audit.symmetry);
  }
}

/// At 1660 rad/s the motion repeats every three revolutions, beside an unstable orbit of one; at 2880 rad/s it never
/// does. There is nothing to jump to, and the answer is that of marching, bit by bit.
TEST(OrbitSearch, FallsBackOnMarchingWhereNoSteadyOrbitIs) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  const Casing casing = testing::lobed_casing(2, 2e-4, 1e-4);
  for (const double speed : {1660.0, 2880.0}) {
    const SpeedResponse plain = run(model, casing, speed, SteadyStateMethod::march);
    const SpeedResponse tried = run(model, casing, speed, SteadyStateMethod::orbit);
    EXPECT_EQ(plain.period_revolutions, speed == 1660 ? 3 : 0);
    EXPECT_EQ(tried.period_revolutions, plain.period_revolutions);
    EXPECT_EQ(tried.audit.orbit.outcome, Outcome::marched);
    EXPECT_EQ(tried.displacement, plain.displacement);
    EXPECT_EQ(tried.contact_force, plain.contact_force);
    EXPECT_EQ(tried.revolutions, plain.revolutions);
  }
}

/// What leaves the repelling orbit at 2880 rad/s does not come back to its phase within a recording. The search
/// therefore ends with that orbit, and the motion is that of the march. Looking for orbits of several maps would cost
/// 270 revolutions.
TEST(OrbitSearch, EndsWithARepellingOrbitToWhichNothingLocks) {
  OneSpeed at(2880);
  at.parameters.recorded_revolutions = 6;
  const SettledMotion plain = settle(at.scene, at.rotor, {}, at.plan);
  for (const OrbitUse use : {OrbitUse::motion, OrbitUse::amplitude}) {
    OrbitSearch search(at.scene, use);
    at.plan.search = &search;
    const SettledMotion searched = settle(at.scene, at.rotor, {}, at.plan);
    ASSERT_EQ(search.report().outcome, Outcome::marched);
    EXPECT_EQ(search.report().maps, 1);
    EXPECT_LT(search.report().revolutions, 60);
    EXPECT_EQ(searched.recorded.displacement, plain.recorded.displacement);
  }
}

/// The same motion of three revolutions, if so many are kept.
TEST(OrbitSearch, FindsOrbitsOfManyMaps) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  const Casing casing = testing::lobed_casing(2, 2e-4, 1e-4);
  const Kept kept{6};
  const SpeedResponse plain = run(model, casing, 1660, SteadyStateMethod::march, Scheme::trigonometric, kept);
  const SpeedResponse found = run(model, casing, 1660, SteadyStateMethod::orbit, Scheme::trigonometric, kept);
  ASSERT_EQ(plain.period_revolutions, 3);
  ASSERT_EQ(found.audit.orbit.outcome, Outcome::found);
  EXPECT_EQ(found.period_revolutions, 3);
  EXPECT_GT(found.audit.orbit.maps, 1);
  EXPECT_LT(found.audit.orbit.multiplier, 1);
  EXPECT_EQ(found.motion, plain.motion);
  EXPECT_EQ(found.period_beats, plain.period_beats);
  EXPECT_LT(testing::difference(found, plain, casing.lobes).value, 1e-4);
}

/// The motion at 2880 rad/s never repeats: marching on would not change what can be said of it.
TEST(SettledMarch, LeavesAMotionThatWandersBeforeAllRevolutionsAreMarched) {
  OneSpeed at(2880);
  at.parameters.max_revolutions = 400;
  const SettledMotion left = settle(at.scene, at.rotor, {}, at.plan);
  EXPECT_EQ(left.state.period_revolutions, 0);
  EXPECT_GE(left.revolutions, 60);
  EXPECT_LT(left.revolutions, 200);
  at.plan.start = StartMotion::wanders;
  const SettledMotion after = settle(at.scene, at.rotor, state_of(*left.march, at.model), at.plan);
  EXPECT_EQ(after.state.period_revolutions, 0);
  EXPECT_GE(after.revolutions, 30);
  EXPECT_LT(after.revolutions, 60) << "its transient has passed";
}

/// A scan's search for an orbit takes place along its own march, which goes on if there is none to be kept: the
/// motion at 1660 rad/s repeats every three revolutions, and two are recorded.
TEST(SettledMarch, GoesOnAfterASearchThatFoundNothing) {
  OneSpeed at(1660);
  OrbitSearch search(at.scene, OrbitUse::motion);
  const SettledMotion plain = settle(at.scene, at.rotor, {}, at.plan);
  at.plan.search = &search;
  const SettledMotion searched = settle(at.scene, at.rotor, {}, at.plan);
  EXPECT_EQ(search.report().outcome, Outcome::marched);
  EXPECT_EQ(searched.state.period_revolutions, 3);
  EXPECT_EQ(searched.state.period_revolutions, plain.state.period_revolutions);
  EXPECT_LT(difference(searched.sampled(), plain.sampled(), at.casing.lobes).value, 1e-4);
}

/// A wheel that reaches no casing comes to rest: nothing is divided by its motion.
TEST(OrbitSearch, TakesRestForAnOrbit) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  const SpeedResponse rest = run(model, testing::lobed_casing(2, 1e-4, 1.0), 2000, SteadyStateMethod::orbit);
  EXPECT_EQ(rest.failure, "");
  EXPECT_EQ(rest.amplitude, 0);
}

/// Central differences grow with the coarse step: the search fails, the speed is marched.
TEST(OrbitSearch, SurvivesAStepBeyondTheLimitOfItsScheme) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  const Casing casing = testing::lobed_casing(2, 2e-4, 1e-4);
  const SpeedResponse plain = run(model, casing, 2000, SteadyStateMethod::march, Scheme::central_differences);
  const SpeedResponse tried = run(model, casing, 2000, SteadyStateMethod::orbit, Scheme::central_differences);
  EXPECT_EQ(tried.failure, plain.failure);
  EXPECT_EQ(tried.settled(), plain.settled());
}

}  // namespace
}  // namespace tiprub::simulate
