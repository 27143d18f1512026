// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/marched_scene.h"

#include <gtest/gtest.h>

#include <numbers>

#include "cases/program/errors.h"
#include "simulate/march/march_state.h"
#include "simulate/motion/attempt.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

const ReducedModel wheel = testing::synthetic_wheel({});

MarchedScene scene_with(const Casing& casing, double speed, int steps, SimulateParameters parameters = {}) {
  parameters.samples_per_revolution = 60;
  const SceneScope scope = find_scope(wheel.sector_count, casing.lobes, parameters);
  const Scene scene{wheel, casing, parameters, scope};
  return marched_scene(scene, rotor_of(scene, speed), steps);
}

/// The gaps of a wheel at rest are what the obstacle says: its clearance less its distortion at the angle that a tip
/// has come to.
TEST(Obstacle, GivesTheGapsOfAWheelAtRest) {
  constexpr int steps = 1200;
  const Casing casing = testing::lobed_casing(2, 1e-4, 3e-4);
  TimeMarch march(scene_with(casing, 900, steps));
  const Obstacle& obstacle = march.scene().obstacle;
  for (const int step : {0, 300, 1700}) {
    march.set_step(step);
    for (int j = 0; j < march.sectors(); ++j)
      for (int k = 0; k < march.node_count(); ++k) {
        const double turn = 2 * std::numbers::pi *
                            (static_cast<double>(step) / steps + static_cast<double>(j) / march.sector_count());
        const double grown = obstacle.grown(static_cast<double>(step) / steps);
        EXPECT_NEAR(march.gap()[j * march.width() + k],
                    obstacle.clearance(j)[k] - grown * obstacle.distortion(k, turn), 1e-18);
      }
  }
}

TEST(Obstacle, ThatAllTipsTouchMakesGapsOfDisplacements) {
  MarchedScene scene = scene_with(testing::lobed_casing(2, 1e-4, 3e-4), 900, 1200);
  scene.obstacle = scene.obstacle.touching();
  TimeMarch march(scene);
  march.set_state(0, Eigen::VectorXcd::Constant(1, 1e-6), Eigen::VectorXcd::Zero(1));
  EXPECT_GT(march.displacement().norm(), 0);
  for (int j = 0; j < march.sectors(); ++j)
    EXPECT_EQ(march.gap().segment(j * march.width(), march.node_count()),
              -march.displacement().segment(j * march.width(), march.node_count()));
}

/// Each scheme is made from the case with all that it needs: branches once marched without theta and springs.
TEST(MarchedScene, HasAllThatASchemeNeeds) {
  SimulateParameters parameters;
  parameters.scheme = Scheme::penalty;
  parameters.theta = 0.6;
  parameters.penalty_stiffness = 7;
  const MarchedScene scene = scene_with(testing::lobed_casing(2, 1e-4, 3e-4), 900, 1200, parameters);
  EXPECT_EQ(scene.setup.scheme, Scheme::penalty);
  EXPECT_EQ(scene.setup.steps_per_revolution, 1200);
  EXPECT_EQ(scene.setup.symmetry, 2);
  EXPECT_EQ(scene.setup.theta, 0.6);
  EXPECT_EQ(scene.setup.penalty_stiffness, 7 * scene.rotor->tip_stiffness);
  EXPECT_EQ(scene.omega_max(), penalised_omega_max(*scene.rotor, scene.setup.penalty_stiffness));
}

/// A scan leaves out the nodal diameters that do not move, but its springs are those of the march that follows.
TEST(MarchedScene, ScalesSpringsByTheWholeTip) {
  SimulateParameters parameters;
  parameters.scheme = Scheme::penalty;
  parameters.samples_per_revolution = 60;
  const Casing casing = testing::lobed_casing(2, 1e-4, 3e-4);
  const Scene scene{wheel, casing, parameters, find_scope(wheel.sector_count, casing.lobes, parameters)};
  ASSERT_LT(scene.scope.nodal_diameters.size(), wheel.nodal_diameters.size());
  EXPECT_EQ(rotor_of(scene, 900, OtherDiameters::unknown)->tip_stiffness, rotor_of(scene, 900)->tip_stiffness);
}

/// Symptom once: what ends the program (a disk that is full, say) and what ends a branch were one exception, and both
/// were dropped where no orbit was found.
TEST(Attempt, TakesThatThereIsNoMotionAndNothingElse) {
  const auto found = attempt([] { return 3; });
  EXPECT_EQ(found.result.value_or(0), 3);
  EXPECT_EQ(found.failure, "");
  const auto closed =
      attempt([] { return scene_with(testing::lobed_casing(2, 1e-4, -1e-3), 900, 1200).tips.size(); });
  EXPECT_FALSE(closed.result.has_value());
  EXPECT_NE(closed.failure.find("spin closes the clearance"), std::string::npos);
  EXPECT_THROW(attempt([]() -> int { throw RunError("no space left on device"); }), RunError);
}

/// Twice the kinetic and elastic energy of the modes at the last two instants; what is put comes back.
TEST(EnergyState, ComesBackAsItWasPut) {
  testing::Bench bench = testing::make_bench(wheel, testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.01,
                                             {Scheme::trigonometric, ContactRule::complementarity, 1200, 1});
  for (int i = 0; i < 2400; ++i) bench.march.step();
  const EnergyState energy(bench.march, 1);
  const Eigen::VectorXd state = energy.of(bench.march);
  EXPECT_EQ(state.size(), energy.layout().size());
  EXPECT_GT(state.norm(), 0);
  energy.put(2 * state, bench.march);
  EXPECT_LT((energy.of(bench.march) - 2 * state).norm(), 1e-10 * state.norm());
}

}  // namespace
}  // namespace tiprub::simulate
