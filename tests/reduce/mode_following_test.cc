// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/mode_following.h"

#include <gtest/gtest.h>

#include "tests/reduce/complaint.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub {
namespace {

using test::cyclic;
using test::TestRotor;

constexpr int sectors = 5, count = 6;
constexpr double top = 3000.0;  // [rad/s]

/// Modes at rest are followed to two thirds of a speed whose factor is at hand.
class ModeFollowing : public ::testing::TestWithParam<int> {
 protected:
  ModeFollowing()
      : rotor_(test::tip_rotor(test::skewed_annulus(sectors))),
        wave_(rotor_.dofs(), sectors, GetParam()),
        mass_(rotor_.mass()),
        between_(rotor_.at_speed(2 * top / 3, Prestress::linear)),
        factor_(rotor_.at_speed(top, Prestress::linear), rotor_.dofs()),
        nearby_(factor_, wave_) {}

  CyclicModes follow(double tolerance) {
    const SectorFactor rest(rotor_.at_rest(), rotor_.dofs());
    const CyclicModes guesses =
        lowest_modes(CyclicStiffness(rest, wave_), mass_, ContactNodes::free, 2 * count, 1e-7);
    return follow_modes(nearby_, between_, mass_, guesses.shape, count, tolerance);
  }
  Eigen::MatrixXcd unreduced(const SymmetricMatrix& matrix) const {
    return cyclic(matrix, rotor_.dofs(), sectors, GetParam());
  }

  TestRotor rotor_;
  TravellingWave wave_;
  SymmetricMatrix mass_, between_;
  SectorFactor factor_;
  CyclicStiffness nearby_;
};
INSTANTIATE_TEST_SUITE_P(NodalDiameter, ModeFollowing, ::testing::Values(0, 1, 2));

TEST_P(ModeFollowing, EqualsDenseAlgebra) {
  const CyclicModes modes = follow(1e-9);
  const Eigen::VectorXd exact = test::generalized_eigenvalues(unreduced(between_), unreduced(mass_));
  for (int k = 0; k < count; ++k) {
    EXPECT_NEAR(modes.eigenvalue[k] / exact[k], 1.0, 1e-8) << k;
    EXPECT_GE(modes.eigenvalue[k], exact[k] * (1 - 1e-9)) << k;  // from above
  }
}

TEST_P(ModeFollowing, GivesOrthonormalShapesOfTheirEquation) {
  const CyclicModes modes = follow(1e-9);
  const Eigen::MatrixXcd Kx = unreduced(between_) * modes.shape, Mx = unreduced(mass_) * modes.shape;
  EXPECT_LT((modes.shape.adjoint() * Mx - Eigen::MatrixXcd::Identity(count, count)).cwiseAbs().maxCoeff(), 1e-10);
  for (int k = 0; k < count; ++k)
    EXPECT_LT((Kx.col(k) - modes.eigenvalue[k] * Mx.col(k)).norm(), 1e-2 * Kx.col(k).norm()) << k;
}

TEST_P(ModeFollowing, ALooserToleranceErrsByNoMoreThanIt) {
  const Eigen::VectorXd exact = test::generalized_eigenvalues(unreduced(between_), unreduced(mass_));
  for (const double tolerance : {1e-3, 1e-5}) {
    const CyclicModes modes = follow(tolerance);
    for (int k = 0; k < count; ++k) EXPECT_LT(modes.eigenvalue[k] / exact[k] - 1, tolerance) << k;
    EXPECT_LT(modes.residual.maxCoeff(), tolerance);
  }
}

TEST_P(ModeFollowing, CallsNoRotorUnstableBecauseTheToleranceIsTight) {
  // Near rounding, either the modes are right or the message says that they could not be followed.
  const Eigen::VectorXd exact = test::generalized_eigenvalues(unreduced(between_), unreduced(mass_));
  const std::string message = test::complaint<RunError>([&] {
    const CyclicModes modes = follow(1e-15);
    for (int k = 0; k < count; ++k) EXPECT_NEAR(modes.eigenvalue[k] / exact[k], 1.0, 1e-8) << k;
  });
  EXPECT_EQ(message.find("unstable"), std::string::npos) << message;
}

TEST_P(ModeFollowing, RefusesAStiffnessThatIsNotPositive) {
  SymmetricMatrix negative = -between_;
  const Eigen::MatrixXcd guesses = wave_.standing()
                                       ? Eigen::MatrixXcd(test::arbitrary(rotor_.dofs().independent(), count).real())
                                       : test::arbitrary(rotor_.dofs().independent(), count);
  const std::string message =
      test::complaint<RunError>([&] { follow_modes(nearby_, negative, mass_, guesses, count, 1e-6); });
  EXPECT_NE(message.find("not positive definite: the rotor is unstable"), std::string::npos) << message;
}

}  // namespace
}  // namespace tiprub
