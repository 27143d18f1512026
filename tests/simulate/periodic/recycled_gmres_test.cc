// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/recycled_gmres.h"

#include <gtest/gtest.h>

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

int solve_and_count(RecycledGmres& solver, const Eigen::MatrixXd& map, double tolerance) {
  const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(map.rows(), 1, 2);
  const int before = solver.steps();
  const Eigen::VectorXd x =
      solver.solve([&](const Eigen::VectorXd& change) { return Eigen::VectorXd(map * change); }, f, tolerance);
  EXPECT_LE((f - x + map * x).norm(), 1.001 * tolerance * f.norm());
  return solver.steps() - before;
}

TEST(RecycledGmres, SolvesTheSecondProblemWithWhatTheFirstHasTaught) {
  RecycledGmres solver;
  const int first = solve_and_count(solver, slow_and_fast(0.99), 1e-2);
  const int second = solve_and_count(solver, slow_and_fast(0.991), 1e-2);
  EXPECT_GT(first, 50);
  EXPECT_LT(second, first / 4);
}

TEST(RecycledGmres, SolvesExactlyWhatIsSmall) {
  RecycledGmres solver;
  const Eigen::MatrixXd map = 0.5 * Eigen::MatrixXd::Identity(3, 3);
  EXPECT_EQ(solve_and_count(solver, map, 1e-12), 1);
  EXPECT_EQ(solver.solve([](const Eigen::VectorXd& x) { return x; }, Eigen::VectorXd::Zero(3), 1e-3).norm(), 0);
}

}  // namespace
}  // namespace tiprub::simulate
