// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/multipliers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tiprub::simulate {
namespace {

/// A diagonal block: values between two bounds; and a pair that turns.
Multiplier of(double low, double high, double pair, double angle) {
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(302, 302);
  map.diagonal().head(300) = Eigen::VectorXd::LinSpaced(300, low, high);
  map.bottomRightCorner<2, 2>() << pair * std::cos(angle), -pair * std::sin(angle), pair * std::sin(angle),
      pair * std::cos(angle);
  return largest_multiplier([&](const Eigen::VectorXd& x) { return Eigen::VectorXd(map * x); }, map.rows());
}

TEST(Multipliers, FindsTheLargestWhereverItLies) {
  const Multiplier flip = of(-0.99, 0.9, 0.5, 1);
  EXPECT_NEAR(flip.value.real(), -0.99, 1e-3);
  EXPECT_NEAR(std::abs(flip.value.imag()), 0, 1e-3);
  const Multiplier torus = of(-0.6, 0.9, 1.02, 2);
  EXPECT_NEAR(std::abs(torus.value), 1.02, 2e-3);
  EXPECT_NEAR(std::abs(std::arg(torus.value)), 2, 2e-3);
  EXPECT_NEAR(of(-0.6, 1.3, 1.02, 2).value.real(), 1.3, 2e-3);
}

TEST(Multipliers, StandsBesideManyOfNearlyItsSize) {
  const Multiplier one = of(0.97, 0.99, 0.9905, 0.4);
  EXPECT_NEAR(std::abs(one.value), 0.9905, one.uncertainty + 1e-12);
  EXPECT_LE(one.uncertainty, 1e-3);
}

}  // namespace
}  // namespace tiprub::simulate
