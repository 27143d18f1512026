// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/damping.h"

#include <gtest/gtest.h>

#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

TEST(Damping, IsByFamilyAndTheLastOneHolds) {
  const Damping damping{0.01, 0.002};
  EXPECT_EQ(damping.ratio(2, 0, 100), 0.01);
  EXPECT_EQ(damping.ratio(2, 1, 100), 0.002);
  EXPECT_EQ(damping.ratio(2, 7, 1e6), 0.002);
  EXPECT_EQ(damping.largest(), 0.01);
}

TEST(Damping, IsByFrequencyLinearBetweenPoints) {
  Damping damping;
  damping.ratios = {.by_frequency = {{1000, 0.002}, {3000, 0.006}}};
  EXPECT_EQ(damping.ratio(2, 0, 10), 0.002);
  EXPECT_DOUBLE_EQ(damping.ratio(2, 3, 2000), 0.004);
  EXPECT_EQ(damping.ratio(2, 0, 9000), 0.006);
  EXPECT_EQ(damping.largest(), 0.006);
}

/// Symptom: a point that no mode reaches made the scan seven times as dense.
TEST(Damping, IsSmallestAndLargestAmongResolvedModes) {
  Damping damping;
  damping.ratios = {.by_frequency = {{0, 0.02}, {6000, 0.02}, {10000, 0.0002}, {20000, 0.5}}};
  EXPECT_EQ(damping.smallest(), 0.0002);
  damping.resolved_frequency = 6000, damping.ratios.beyond = 0.02;
  EXPECT_EQ(damping.smallest(), 0.02);
  EXPECT_EQ(damping.largest(), 0.02);
  damping.resolved_frequency = 8000, damping.ratios.beyond = 0.02;
  EXPECT_DOUBLE_EQ(damping.smallest(), 0.0101);
}

TEST(Damping, IsAnotherOneBeyondTheResolvedFrequency) {
  Damping damping{0.002};
  damping.resolved_frequency = 8000, damping.ratios.beyond = 0.02;
  EXPECT_EQ(damping.ratio(2, 0, 8000), 0.002);
  EXPECT_EQ(damping.ratio(2, 40, 8001), 0.02);
}

// A test on a wheel gives the damping of single modes; all others keep that of their family.
TEST(Damping, IsThatOfASingleModeIfGiven) {
  Damping damping{0.002, 0.004};
  damping.ratios.by_mode = {{3, 1, 0.001}, {0, 0, 0.008}};
  damping.resolved_frequency = 8000, damping.ratios.beyond = 0.02;
  EXPECT_EQ(damping.ratio(3, 1, 1000), 0.001);
  EXPECT_EQ(damping.ratio(3, 0, 1000), 0.002);
  EXPECT_EQ(damping.ratio(2, 1, 1000), 0.004);
  EXPECT_EQ(damping.ratio(0, 0, 1000), 0.008);
  EXPECT_EQ(damping.ratio(3, 1, 8001), 0.02);
  EXPECT_EQ(damping.largest(), 0.008);
  EXPECT_EQ(damping.smallest(), 0.001);
}

TEST(ResolvedFrequency, IsTwiceTheLowestOfTheLastVerifiedOnes) {
  ReducedModel model = testing::synthetic_wheel({});
  EXPECT_TRUE(std::isinf(resolved_frequency(model)));
  Eigen::MatrixXd low(2, 3), high(2, 3);
  low << 1000, 2000, 3000, 1100, 2100, 3200;
  high << 1000, 2000, 3500, 1100, 2100, 2900;
  model.verification.unreduced = {low, high};
  EXPECT_EQ(resolved_frequency(model), 5800);
}

}  // namespace
}  // namespace tiprub::simulate
