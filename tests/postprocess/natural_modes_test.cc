// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_study.h"

#include <gtest/gtest.h>

namespace tiprub::postprocess {
namespace {

/// Two bricks that share a face: nodes 0 .. 3 and 8 .. 11 of the one are 4 .. 7 and others of the next.
SectorFields two_bricks() {
  SectorFields sector;
  sector.cells.resize(20, 2);
  for (int k = 0; k < 20; ++k) {
    sector.cells(k, 0) = k;
    sector.cells(k, 1) = k < 8 ? k : 20 + k - 8;  // eight nodes are both bricks'
  }
  sector.nodes = Eigen::Matrix3Xd::Zero(3, 32);
  sector.parts = {{"disc", {0}}, {"main_blade", {1}}};
  return sector;
}

TEST(NaturalModes, SharesOfAnEvenMotionAreThoseOfTheVolumes) {
  const Eigen::Matrix3Xcd even = Eigen::Matrix3Xcd::Constant(3, 32, std::complex<double>(0.6, -0.8));
  const auto shares = part_shares(two_bricks(), Eigen::Vector2d(3, 1), even);
  EXPECT_NEAR(shares.at("disc"), 0.75, 1e-12);
  EXPECT_NEAR(shares.at("main_blade"), 0.25, 1e-12);
}

/// Of 20 nodes each 12 are the blade's alone: its mean is 12/20, the disc's 0; with the shared ones 20/20 and 8/20.
TEST(NaturalModes, SharesFollowTheMotion) {
  Eigen::Matrix3Xcd motion = Eigen::Matrix3Xcd::Zero(3, 32);
  motion.row(2).tail(12).setConstant(2);
  EXPECT_EQ(part_shares(two_bricks(), Eigen::Vector2d(1, 1), motion).at("disc"), 0);
  motion.row(2).head(8).setConstant(2);
  EXPECT_NEAR(part_shares(two_bricks(), Eigen::Vector2d(1, 1), motion).at("disc"), 8.0 / 28, 1e-12);
  EXPECT_EQ(part_shares(two_bricks(), Eigen::Vector2d(1, 1), Eigen::Matrix3Xcd::Zero(3, 32)).at("disc"), 0);
}

/// Family 0 has the most and is not asked for; family 2 has the largest two together, though family 1 the largest.
TEST(NaturalModes, ChoosesTheFamilyByItsTwoLargestShares) {
  std::vector<ModeShares> shares;
  const double disc[3][3] = {{1, 0.9, 0.3}, {1, 0.1, 0.6}, {1, 0.1, 0.7}};  // by nodal diameter, then family
  for (int n = 0; n < 3; ++n)
    for (int family = 0; family < 3; ++family) shares.push_back({n, family, 100, {{"disc", disc[n][family]}}});
  EXPECT_EQ(disc_modes(shares, 1), (std::vector<std::size_t>{5, 8}));
  EXPECT_EQ(disc_modes(shares, 3), (std::vector<std::size_t>{}));
  for (ModeShares& mode : shares) mode.share.clear();  // parts that nobody told apart
  EXPECT_EQ(disc_modes(shares, 1), (std::vector<std::size_t>{}));
}

}  // namespace
}  // namespace tiprub::postprocess
