// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/branch_runs.h"

#include <gtest/gtest.h>

#include "simulate/speed/speed_run.h"
#include "simulate/sweep/simulated_scene.h"
#include "tests/cases/temporary_folder.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

/// Three speeds of a wheel, the first two examined.
class BranchRuns : public TemporaryFolder {
 protected:
  std::vector<OrbitBranch> follow(BranchChoice choice, SweepDirection sweep) {
    SimulateParameters parameters;
    parameters.damping = {0.02};
    parameters.samples_per_revolution = 240;
    parameters.recorded_revolutions = 1;
    parameters.min_revolutions = 20;
    parameters.max_revolutions = 200;
    parameters.settle_tolerance = 1e-4;
    parameters.casing_areas = 1;
    parameters.steps_per_period = 400;
    parameters.branches = choice;
    parameters.branch_range = 0.01;
    parameters.branch_steps = 40;
    parameters.sweep = sweep;
    const SceneScope scope = find_scope(model_.sector_count, casing_.lobes, parameters);
    const Scene scene{model_, casing_, parameters, scope};
    FinishedSpeeds finished(path("r.h5"), simulated_scene(scene, {"", ""}), "key", "test");
    for (const double speed : speeds_) {
      SpeedResponse response = simulate_speed(scene, speed).response;
      if (speed < speeds_.back())
        response.depth = deepest_;
      else
        response.amplitude *= raised_;
      if (speed == examined_) response.depth = Depth::examined;
      finished.keep(response);
    }
    return follow_branches(scene, speeds_, finished, Progress::Shown::never);
  }

  const ReducedModel model_ = testing::synthetic_wheel({5, 2, 4});
  const Casing casing_ = testing::lobed_casing(3, 2e-4, 1e-4);
  std::vector<double> speeds_{1990, 2000, 2100};
  Depth deepest_ = Depth::examined;  ///< of all speeds but the last
  double examined_ = 0;              ///< [rad/s] a speed that is examined in any case
  double raised_ = 1;                ///< the last amplitude, as if a jump came before it
};

/// The second examined speed lies on the branch of the first; the last speed was not examined.
TEST_F(BranchRuns, FollowEachBranchOnce) {
  const std::vector<OrbitBranch> branches = follow(BranchChoice::critical_speeds, SweepDirection::rest);
  ASSERT_EQ(branches.size(), 1u);
  EXPECT_EQ(branches[0].start, 1990);
  EXPECT_NEAR(branches[0].speed.minCoeff(), 0.99 * 1990, 1e-6);
  EXPECT_NEAR(branches[0].speed.maxCoeff(), 1.01 * 1990, 1e-6);
}

/// Symptom once: a jump without a peak, at which no speed was examined, started no branch.
TEST_F(BranchRuns, BeginAtBothSidesOfAJump) {
  speeds_ = {2000, 2004};
  deepest_ = Depth::full;
  EXPECT_TRUE(follow(BranchChoice::critical_speeds, SweepDirection::rest).empty()) << "no jump";
  raised_ = 2;
  const std::vector<OrbitBranch> branches = follow(BranchChoice::critical_speeds, SweepDirection::rest);
  ASSERT_EQ(branches.size(), 2u);
  EXPECT_EQ(branches[0].start, 2000);
  EXPECT_EQ(branches[1].start, 2004);
}

TEST_F(BranchRuns, BeginAtEverySpeedOnNoOtherBranchIfAsked) {
  deepest_ = Depth::full;
  const std::vector<OrbitBranch> branches = follow(BranchChoice::speeds, SweepDirection::rest);
  ASSERT_EQ(branches.size(), 2u);
  EXPECT_EQ(branches[0].start, 1990);
  EXPECT_EQ(branches[1].start, 2100);
}

/// Symptom: a critical speed at the end of a branch that had begun at a lower speed got none of its own.
TEST_F(BranchRuns, BeginAtExaminedSpeedsFirst) {
  deepest_ = Depth::full;
  examined_ = 2000;
  const std::vector<OrbitBranch> branches = follow(BranchChoice::speeds, SweepDirection::rest);
  ASSERT_EQ(branches.size(), 2u);
  EXPECT_EQ(branches[0].start, 2000) << "the branch passes 1990 rad/s";
  EXPECT_EQ(branches[1].start, 2100);
}

TEST_F(BranchRuns, FollowNoneUnlessAsked) {
  EXPECT_TRUE(follow(BranchChoice::none, SweepDirection::rest).empty());
  EXPECT_TRUE(follow(BranchChoice::critical_speeds, SweepDirection::up).empty());
}

}  // namespace
}  // namespace tiprub::simulate
