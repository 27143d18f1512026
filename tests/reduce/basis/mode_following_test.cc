// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/mode_following.h"

#include <gtest/gtest.h>

#include "reduce/basis/cyclic_modes.h"
#include "tests/cases/complaint.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::mode_following_test {
namespace {

using test::cyclic;
using test::project;
using test::TestRotor;

constexpr int sectors = 5, count = 6;
constexpr double top = 3000.0;  // [rad/s]

/// The modes of a small basis are followed at two speeds, each with the factor of rest or of full speed.
class ModeFollowingTest : public ::testing::TestWithParam<int> {
 protected:
  ModeFollowingTest()
      : rotor_(test::tip_rotor(test::skewed_annulus(sectors))),
        wave_(rotor_.dofs(), sectors, GetParam()),
        mass_(rotor_.mass()),
        at_rest_(rotor_.at_rest()),
        rest_factor_(at_rest_, rotor_.dofs()),
        full_factor_(rotor_.at_speed(top, Prestress::linear), rotor_.dofs()),
        rest_(rest_factor_, wave_),
        full_(full_factor_, wave_),
        basis_(wave_, mass_, {&at_rest_}, rest_.constraint_modes()) {
    for (const double speed : {top / 3, 2 * top / 3}) stiffness_.push_back(rotor_.at_speed(speed, Prestress::linear));
    samples_ = {stiffness_[0] + stiffness_[1], stiffness_[0] - stiffness_[1]};
    basis_.append(lowest_modes(rest_, mass_, ContactNodes::fixed, 2 * count, 1e-7).shape);
    basis_.append(full_.constraint_modes() - rest_.constraint_modes());
    basis_.orthonormalise();
  }

  ModeFollowing following(double sign = 1.0) {
    std::vector<SpeedToFollow> speeds;
    for (std::size_t s = 0; s < stiffness_.size(); ++s)
      speeds.push_back({s == 0 ? "slowly" : "fast", sign * Eigen::Vector2d(0.5, s == 0 ? 0.5 : -0.5),
                        sign * project(wave_, stiffness_[s], basis_.shapes()), s == 0 ? &rest_ : &full_});
    return {basis_, mass_, samples_, std::move(speeds), count};
  }
  Eigen::VectorXd exact(std::size_t speed) const {
    return test::generalized_eigenvalues(cyclic(stiffness_[speed], rotor_.dofs(), sectors, GetParam()),
                                         cyclic(mass_, rotor_.dofs(), sectors, GetParam()));
  }

  TestRotor rotor_;
  CyclicTransformation wave_;
  SymmetricMatrix mass_, at_rest_;
  SectorFactor rest_factor_, full_factor_;
  CyclicSolver rest_, full_;
  CraigBamptonBasis basis_;
  std::vector<SymmetricMatrix> stiffness_, samples_;
};
INSTANTIATE_TEST_SUITE_P(NodalDiameter, ModeFollowingTest, ::testing::Values(0, 1, 2));

TEST_P(ModeFollowingTest, EqualsDenseAlgebra) {
  ModeFollowing modes = following();
  modes.converge(1e-9);
  for (std::size_t s = 0; s < stiffness_.size(); ++s) {
    const Eigen::VectorXd truth = exact(s);
    for (int k = 0; k < count; ++k) {
      EXPECT_NEAR(modes.modes()[s].eigenvalue[k] / truth[k], 1.0, 1e-8) << k;
      EXPECT_GE(modes.modes()[s].eigenvalue[k], truth[k] * (1 - 1e-9)) << k;  // from above
    }
  }
}

TEST_P(ModeFollowingTest, EstimatesTheErrorOfTheBasis) {
  ModeFollowing modes = following();
  const std::vector<FollowedModes> guesses = modes.modes();
  for (std::size_t s = 0; s < stiffness_.size(); ++s) modes.missing(s, 0.0);
  for (std::size_t s = 0; s < stiffness_.size(); ++s) {
    const Eigen::VectorXd truth = exact(s);
    for (int k = 0; k < count; ++k) {
      const double error = guesses[s].eigenvalue[k] / truth[k] - 1;
      EXPECT_GT(modes.modes()[s].error[k], 0.5 * error) << k;
      EXPECT_LT(modes.modes()[s].error[k], 2 * error) << k;
    }
  }
}

TEST_P(ModeFollowingTest, ALooserToleranceErrsByNoMoreThanTwiceIt) {
  for (const double tolerance : {1e-3, 1e-5}) {
    ModeFollowing modes = following();
    modes.converge(tolerance);
    for (std::size_t s = 0; s < stiffness_.size(); ++s) {
      EXPECT_LE(modes.modes()[s].error.maxCoeff(), tolerance);
      const Eigen::VectorXd truth = exact(s);
      for (int k = 0; k < count; ++k) EXPECT_LT(modes.modes()[s].eigenvalue[k] / truth[k] - 1, 2 * tolerance) << k;
    }
  }
}

TEST_P(ModeFollowingTest, WhatIsMissingMendsTheBasis) {
  ModeFollowing before = following();
  const double guess = before.modes()[1].eigenvalue[count - 1];
  std::vector<Eigen::MatrixXcd> blocks;  // found before any is appended: following() refers to the basis
  for (std::size_t s = 0; s < stiffness_.size(); ++s) blocks.push_back(before.missing(s, 1e-9));
  for (const Eigen::MatrixXcd& block : blocks) {
    ASSERT_GT(block.cols(), 0);
    EXPECT_EQ(block.bottomRows(rotor_.dofs().boundary()).cwiseAbs().maxCoeff(), 0.0);  // contact nodes are held
    basis_.append(block);
  }
  basis_.orthonormalise();
  ModeFollowing after = following();
  const double truth = exact(1)[count - 1];
  EXPECT_LT(after.modes()[1].eigenvalue[count - 1] - truth, 0.1 * (guess - truth));
}

TEST_P(ModeFollowingTest, CallsNoRotorUnstableBecauseTheToleranceIsTight) {
  // Near rounding, either the modes are right or the message says that they could not be followed.
  ModeFollowing modes = following();
  const std::string message = complaint<RunError>([&] { modes.converge(1e-15); });
  const Eigen::VectorXd truth = exact(1);
  for (int k = 0; k < count && message.empty(); ++k)
    EXPECT_NEAR(modes.modes()[1].eigenvalue[k] / truth[k], 1.0, 1e-8) << k;
  EXPECT_EQ(message.find("unstable"), std::string::npos) << message;
}

TEST_P(ModeFollowingTest, RefusesAStiffnessThatIsNotPositive) {
  const std::string message = complaint<RunError>([&] { following(-1.0); });
  EXPECT_NE(message.find("slowly: the stiffness of a nodal diameter is not positive definite: the rotor is unstable"),
            std::string::npos)
      << message;
}

}  // namespace
}  // namespace tiprub::reduce::mode_following_test
