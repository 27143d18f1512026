// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/branches/branch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/branches/orbit_family.h"
#include "simulate/periodic/marched_map.h"
#include "simulate/periodic/multipliers.h"
#include "simulate/periodic/newton.h"
#include "simulate/speed/speed_run.h"
#include "tests/simulate/branches/exact_orbit.h"
#include "tests/simulate/branches/one_sided_spring.h"
#include "tests/simulate/one_sector.h"
#include "tests/simulate/periodic/rebounding_mass.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

/// What a scene refers to, and an orbit to begin with.
struct Bed {
  ReducedModel model;
  Casing casing;
  SimulateParameters parameters;
  SceneScope scope;

  Bed(ReducedModel given, const Casing& around, double damping) : model(std::move(given)), casing(around), scope() {
    parameters.damping = {damping};
    parameters.samples_per_revolution = 240;
    parameters.recorded_revolutions = 1;
    parameters.min_revolutions = 20;
    parameters.max_revolutions = 2000;
    parameters.settle_tolerance = 1e-8;
    parameters.casing_areas = 1;
  }
  Scene scene() {
    scope = find_scope(model.sector_count, casing.lobes, parameters);
    return {model, casing, parameters, scope};
  }
  /// From rest, some revolutions, then Newton's method.
  Eigen::VectorXd orbit(double speed, int steps, int revolutions) {
    const Scene at = scene();
    TimeMarch march(marched_scene(at, rotor_of(at, speed, OtherDiameters::unknown), steps));
    for (int i = 0; i < revolutions * steps; ++i) march.step();
    return near(march);
  }
  /// Of one mass, from a state at a crest of the casing [m, m/s].
  Eigen::VectorXd orbit_from(double speed, int steps, double displacement, double velocity) {
    const Scene at = scene();
    TimeMarch march(marched_scene(at, rotor_of(at, speed, OtherDiameters::unknown), steps));
    march.set_step(casing.grown_after() * steps);
    const Eigen::MatrixXcd& Y = march.rotor().waves[0].normal_rows;
    const Eigen::VectorXcd unit = Y.adjoint() / Y.squaredNorm();
    march.set_state(0, unit * displacement, unit * (velocity * march.time_step()));
    return near(march);
  }

 private:
  static Eigen::VectorXd near(TimeMarch& march) {
    MarchedMap map(march);
    const NewtonResult found = find_fixed_point(map, map.symmetric().state(), {1e-9});
    EXPECT_TRUE(found.found);
    return found.state;
  }
};

TEST(OrbitFamily, TurnsStatesThereAndBack) {
  Bed bed(testing::synthetic_wheel({5, 2, 4}), testing::lobed_casing(3, 2e-4, 1e-4), 0.02);
  const Eigen::VectorXd orbit = bed.orbit(2000, 1200, 20);
  const Scene scene = bed.scene();
  OrbitFamily family(scene, 2000, 1200);
  const Eigen::VectorXd state = family.of_family(2000, orbit);
  EXPECT_LT((family.of_march(2000, state) - orbit).norm(), 1e-12 * orbit.norm());
  EXPECT_NEAR(state.norm(), orbit.norm(), 1e-9 * orbit.norm()) << "a turn at the reference speed";
  EXPECT_LT((family.at(2000)->image(state).state - state).norm(), 1e-7 * state.norm()) << "a fixed point stays one";
}

/// Every orbit of a branch is what a march from rest settles to, where it attracts and nothing else does.
TEST(Branch, HasTheMotionsOfTheSweepWhereTheyAttract) {
  Bed bed(testing::synthetic_wheel({5, 2, 4}), testing::lobed_casing(3, 2e-4, 1e-4), 0.02);
  const Eigen::VectorXd orbit = bed.orbit(2000, 1200, 20);
  const Scene scene = bed.scene();
  const OrbitBranch branch = follow_branch(scene, 2000, 1200, orbit, {1940, 2060, 2e-3, 40});
  EXPECT_EQ(branch.ends[0], "end of the range");
  EXPECT_EQ(branch.ends[1], "end of the range");
  EXPECT_NEAR(branch.speed[0], 1940, 1e-6);
  EXPECT_NEAR(branch.speed[branch.speed.size() - 1], 2060, 1e-6);
  bed.parameters.steps_per_revolution = 1200;
  for (Eigen::Index i = 0; i < branch.speed.size(); i += 4) {
    const SpeedResponse marched = simulate_speed(bed.scene(), branch.speed[i]).response;
    ASSERT_EQ(marched.motion, MotionClass::periodic);
    ASSERT_TRUE(branch.attracts(i));
    EXPECT_NEAR(branch.amplitude[i], marched.amplitude, 1e-6 * marched.amplitude) << branch.speed[i];
  }
}

/// Two references that share nothing but the equation.
TEST(Branch, HasReferencesThatAgree) {
  const testing::OneSidedSpring plan;
  const std::vector<double> exact = testing::exact_folds(plan, 940, 1200),
                            balance = testing::folds_by_harmonic_balance(plan, 940, 1200);
  ASSERT_EQ(exact.size(), 2u);
  ASSERT_EQ(balance.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(balance[i], exact[i], 1e-3 * exact[i]);
}

/// A mass with a one-sided spring that the casing pushes. Forces act from the step in which they are found on: the
/// march is of first order.
struct OneSidedBed : Bed {
  testing::OneSidedSpring plan;
  OneSidedBed() : OneSidedBed(testing::OneSidedSpring{}) {}

 private:
  explicit OneSidedBed(const testing::OneSidedSpring& given)
      : Bed(testing::one_sided_spring(given), testing::lobed_casing(1, given.amplitude, given.clearance),
            given.damping) {
    parameters.scheme = Scheme::residual_flexibility;
    parameters.modes = 1;
  }
};

void expect_first_order(const std::vector<double>& errors, const char* what) {
  EXPECT_LT(errors.back(), 1e-3) << what;
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_NEAR(errors[i - 1] / errors[i], 2, 0.2) << what;
}

constexpr int finer_and_finer[] = {2400, 4800, 9600};

TEST(Branch, HasOrbitsThatConvergeToTheExactOnes) {
  OneSidedBed bed;
  for (const double speed : {950.0, 1100.0}) {
    const testing::ExactOrbit exact =
        testing::exact_orbit(bed.plan, speed, Eigen::Vector2d::Zero(), bed.parameters.samples_per_revolution);
    std::vector<double> amplitude, multiplier;
    for (const int steps : finer_and_finer) {
      const Eigen::VectorXd orbit = bed.orbit(speed, steps, 200);
      const Scene scene = bed.scene();
      OrbitFamily family(scene, speed, steps);
      const std::shared_ptr<PeriodicMap> map = family.at(speed);
      const Eigen::VectorXd state = family.of_family(speed, orbit);
      const MapImage image = map->image(state);
      const Multiplier largest = largest_multiplier(
          [&](const Eigen::VectorXd& change) { return map->tangent(image.pattern, change); }, state.size());
      amplitude.push_back(std::abs(family.amplitude(speed, state) / exact.amplitude - 1));
      multiplier.push_back(std::abs(std::abs(largest.value) / exact.multiplier - 1));
    }
    expect_first_order(amplitude, "amplitude");
    expect_first_order(multiplier, "multiplier");
  }
}

TEST(Branch, HasFoldsThatConvergeToTheExactOnes) {
  OneSidedBed bed;
  const std::vector<double> exact = testing::exact_folds(bed.plan, 940, 1200);
  std::vector<double> lower, upper;
  for (const int steps : finer_and_finer) {
    const Scene scene = bed.scene();
    const OrbitBranch branch = follow_branch(scene, 950, steps, bed.orbit(950, steps, 200), {940, 1200, 1e-3, 400});
    ASSERT_EQ(branch.folds.size(), 2) << steps;
    const auto [low, high] = std::minmax(branch.folds[0], branch.folds[1]);
    lower.push_back(std::abs(low / exact[0] - 1));
    upper.push_back(std::abs(high / exact[1] - 1));
    const Eigen::Index between = std::distance(branch.multiplier.begin(),
                                               std::max_element(branch.multiplier.begin(), branch.multiplier.end()));
    EXPECT_GT(branch.multiplier[between], 1) << "the middle branch repels";
    EXPECT_LT(branch.multiplier_angle[between], 1e-3) << "as at a fold";
  }
  expect_first_order(lower, "lower fold");
  expect_first_order(upper, "upper fold");
}

/// A mass on two coupled springs, one of them along the normal. An event-driven continuation, which locates each
/// impact to rounding, gave the fold and the amplitudes [m] at the start and, behind the fold, at 5360.81 rpm. Other
/// branches pass nearby; symptom once: a step ended on one of them, and folds were reported where the branch has
/// none.
TEST(Branch, StaysOnItsBranchWhereOthersPassNearby) {
  constexpr double rpm = std::numbers::pi / 30, start = 5318.03975 * rpm, fold = 5374.64 * rpm,
                   behind = 5360.81 * rpm;
  constexpr double mass = 0.02;
  ReducedModel wheel = testing::one_sector();
  NodalDiameterModel only;
  Eigen::MatrixXcd K = 8e4 * Eigen::MatrixXcd::Identity(3, 3);
  K(1, 1) = 3e4;
  K(0, 1) = K(1, 0) = 2e4;
  only.K.terms = {K};
  only.M = mass * Eigen::MatrixXcd::Identity(3, 3);
  wheel.nodal_diameters = {only};
  Bed bed(std::move(wheel), testing::lobed_casing(2, 0.13e-3, 0.12e-3), 0.003);
  constexpr int steps = 480;
  const Eigen::VectorXd orbit = bed.orbit(start, steps, 15);
  const Scene scene = bed.scene();
  const OrbitBranch branch = follow_branch(scene, start, steps, orbit, {5300 * rpm, 5390 * rpm, 1e-3, 200});
  const auto begun = std::ranges::find_if(branch.speed, [&](double at) { return std::abs(at / start - 1) < 1e-9; });
  ASSERT_NE(begun, branch.speed.end());
  EXPECT_NEAR(branch.amplitude[begun - branch.speed.begin()], 123.81e-6, 0.2e-6);
  ASSERT_EQ(branch.folds.size(), 1);
  EXPECT_NEAR(branch.folds[0] / fold, 1, 1e-4);
  EXPECT_EQ(branch.ends[0], "end of the range");
  EXPECT_EQ(branch.ends[1], "end of the range");
  const Eigen::Index last = branch.speed.size() - 1;
  EXPECT_NEAR(branch.speed[last], 5300 * rpm, 1e-6);
  Eigen::Index i = last;
  while (branch.speed[i] < behind) --i;
  const double along = (behind - branch.speed[i]) / (branch.speed[i + 1] - branch.speed[i]);
  EXPECT_NEAR(branch.amplitude[i] + along * (branch.amplitude[i + 1] - branch.amplitude[i]), 144.76e-6, 0.8e-6);
}

/// Symptom once: behind the fold of a rigid impact the branch turned back along the orbit it came from, or ended at
/// the fold. Here it follows the repelling half of the closed form.
TEST(Branch, FollowsTheRepellingHalfBehindARigidFold) {
  const testing::ReboundingMass mass{1000, 0.02, 1e-3, 1.2e-3};
  constexpr double start = 1450, first = 1400;
  Bed bed(testing::one_mass_along_the_stop(mass.frequency), testing::lobed_casing(1, mass.amplitude, mass.clearance),
          mass.damping);
  for (const int steps : {240, 480}) {
    const testing::ReboundingOrbit exact = rebounding_orbit(mass, start, testing::Half::attracting);
    const Eigen::VectorXd orbit = bed.orbit_from(start, steps, exact.displacement(0), exact.velocity(0));
    const Scene scene = bed.scene();
    const OrbitBranch branch = follow_branch(scene, start, steps, orbit, {first, 1700, 1e-3, 200});
    ASSERT_EQ(branch.folds.size(), 1) << steps;
    const double fold = rebounding_fold(mass, start, 1700);
    EXPECT_NEAR(branch.folds[0] / fold, 1, 1e-4) << steps;
    EXPECT_EQ(branch.ends[1], "end of the range");
    const Eigen::Index last = branch.speed.size() - 1;
    EXPECT_NEAR(branch.speed[last], first, 1e-6);
    for (Eigen::Index i = 0; i <= last; ++i) {
      if (std::abs(branch.speed[i] / fold - 1) < 1e-3) continue;  // the two halves meet
      const testing::ReboundingOrbit at = rebounding_orbit(
          mass, branch.speed[i], branch.multiplier[i] < 1 ? testing::Half::attracting : testing::Half::repelling);
      EXPECT_NEAR(branch.multiplier[i] / at.multiplier, 1, 0.02) << branch.speed[i];
      EXPECT_NEAR(branch.amplitude[i] / at.swing(240), 1, 1e-3) << branch.speed[i];
    }
    EXPECT_GT(branch.multiplier[last], 3);
  }
}

}  // namespace
}  // namespace tiprub::simulate
