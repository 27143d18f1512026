// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <Eigen/LU>

#include "simulate/periodic/periodic_map.h"

namespace tiprub::simulate {
namespace {

/// Sixty slow modes that turn by different angles, and four hundred fast ones: what a march's map looks like.
Eigen::MatrixXd slow_and_fast(double slowest) {
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(520, 520);
  for (Eigen::Index i = 0; i < 60; ++i) {
    const double angle = 0.1 * static_cast<double>(i + 1), size = slowest - 1e-4 * static_cast<double>(i);
    map.block<2, 2>(2 * i, 2 * i) << size * std::cos(angle), -size * std::sin(angle), size * std::sin(angle),
        size * std::cos(angle);
  }
  map.diagonal().tail(400) = Eigen::VectorXd::LinSpaced(400, 0.01, 0.3);
  return map;
}

/// The products with the map that a solve takes.
int solve_and_count(const Eigen::MatrixXd& map, const Eigen::MatrixXd& near_inverse, double tolerance) {
  const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(map.rows(), 1, 2);
  int products = 0;
  const Eigen::VectorXd x = gmres(
      [&](const Eigen::VectorXd& change) {
        ++products;
        return Eigen::VectorXd(map * change);
      },
      [&](const Eigen::VectorXd& change) { return Eigen::VectorXd(near_inverse * change); }, f, tolerance);
  EXPECT_LE((f - x + map * x).norm(), 1.001 * tolerance * f.norm());
  return products;
}

TEST(Gmres, NeedsFewStepsOnceTheSlowModesAreKnown) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(520, 520), map = slow_and_fast(0.99);
  const int plain = solve_and_count(map, one, 1e-2);
  const int known = solve_and_count(map, (one - slow_and_fast(0.988)).inverse(), 1e-2);
  EXPECT_GT(plain, 50);
  EXPECT_LE(known, 6);
}

TEST(Gmres, SolvesExactlyWhatIsSmall) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(3, 3);
  EXPECT_EQ(solve_and_count(0.5 * one, one, 1e-12), 1);
  const auto same = [](const Eigen::VectorXd& x) { return x; };
  EXPECT_EQ(gmres(same, same, Eigen::VectorXd::Zero(3), 1e-3).norm(), 0);
}

}  // namespace
}  // namespace tiprub::simulate
