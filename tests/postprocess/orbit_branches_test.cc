// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/other_motions.h"

#include <gtest/gtest.h>

#include <numbers>

namespace tiprub::postprocess {
namespace {

/// Up to a fold at 110, back to one at 102, and up again; the middle repels.
OrbitBranch folded() {
  OrbitBranch branch;
  branch.speed.resize(7);
  branch.speed << 100, 105, 110, 106, 102, 108, 120;
  branch.multiplier.resize(7);
  branch.multiplier << 0.9, 0.9, 0.99, 1.2, 0.99, 0.9, 0.9;
  branch.amplitude = branch.speed;
  return branch;
}

TEST(OrbitBranches, TellWhereMoreThanOneOrbitExists) {
  const std::vector<OrbitRange> ranges = ranges_of_many_orbits({folded()});
  ASSERT_FALSE(ranges.empty());
  EXPECT_EQ(ranges.front().low, 102);
  EXPECT_EQ(ranges.back().high, 110);
  for (const OrbitRange& range : ranges) {
    EXPECT_EQ(range.orbits, 3);
    EXPECT_EQ(range.attracting, 2);
  }
}

TEST(OrbitBranches, TellWhereStabilityChanges) {
  OrbitBranch branch = folded();
  branch.multiplier << 0.9, 0.9, 0.81, 1 / 0.81, 1.1, 0.9, 0.9;
  branch.multiplier_angle = Eigen::VectorXd::Constant(7, std::numbers::pi);
  branch.multiplier_angle[4] = 1.5;
  const std::vector<StabilityChange> changes = stability_changes({branch});
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_NEAR(changes[1].speed, 108, 1e-9) << "half-way from 110 to 106";
  EXPECT_EQ(changes[1].kind, Instability::flip);
  EXPECT_GT(changes[0].speed, 102);
  EXPECT_LT(changes[0].speed, 108);
  EXPECT_EQ(changes[0].kind, Instability::torus);
}

TEST(OrbitBranches, AreSilentAboutASingleOne) {
  OrbitBranch plain = folded();
  plain.speed << 100, 101, 102, 103, 104, 105, 106;
  EXPECT_TRUE(ranges_of_many_orbits({plain}).empty());
  EXPECT_TRUE(ranges_of_many_orbits({}).empty());
}

}  // namespace
}  // namespace tiprub::postprocess
