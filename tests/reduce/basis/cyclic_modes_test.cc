// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/cyclic_modes.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/cases/complaint.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::cyclic_modes_test {
namespace {

using test::cyclic;
using test::TestRotor;

constexpr int sectors = 6;
constexpr double tolerance = 1e-7;

class Modes : public ::testing::TestWithParam<ContactNodes> {
 protected:
  Modes()
      : rotor_(test::tip_rotor(test::skewed_annulus(sectors))),
        mass_(rotor_.mass()),
        stiffness_(rotor_.at_speed(2000.0, Prestress::linear)),
        factor_(stiffness_, rotor_.dofs()) {}

  CyclicModes lowest(int n, int count, double residual = tolerance) const {
    return lowest_modes(CyclicSolver(factor_, {rotor_.dofs(), sectors, n}), mass_, GetParam(), count, residual);
  }
  /// Dofs that can move.
  Eigen::Index free_dofs() const {
    return rotor_.dofs().independent() - (GetParam() == ContactNodes::fixed ? rotor_.dofs().boundary() : 0);
  }
  Eigen::MatrixXcd K(int n) const { return moving(cyclic(stiffness_, rotor_.dofs(), sectors, n)); }
  Eigen::MatrixXcd M(int n) const { return moving(cyclic(mass_, rotor_.dofs(), sectors, n)); }
  Eigen::MatrixXcd moving(const Eigen::MatrixXcd& all) const { return all.topLeftCorner(free_dofs(), free_dofs()); }

  TestRotor rotor_;
  SymmetricMatrix mass_, stiffness_;
  SectorFactor factor_;
};
INSTANTIATE_TEST_SUITE_P(Contact, Modes, ::testing::Values(ContactNodes::free, ContactNodes::fixed));

TEST_P(Modes, SatisfyTheirEquation) {
  for (int n = 0; n <= sectors / 2; ++n) {
    const CyclicModes modes = lowest(n, 12);
    const Eigen::MatrixXcd x = modes.shape.topRows(free_dofs());
    const Eigen::MatrixXcd Kx = K(n) * x, Mx = M(n) * x;
    for (Eigen::Index k = 0; k < x.cols(); ++k)
      EXPECT_LT((Kx.col(k) - modes.eigenvalue[k] * Mx.col(k)).norm(), 1e-5 * Kx.col(k).norm()) << n << " " << k;
    EXPECT_LT((x.adjoint() * Mx - Eigen::MatrixXcd::Identity(12, 12)).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_P(Modes, HoldTheContactNodesWhereAsked) {
  const double moved = lowest(1, 4).shape.bottomRows(rotor_.dofs().boundary()).cwiseAbs().maxCoeff();
  if (GetParam() == ContactNodes::fixed)
    EXPECT_EQ(moved, 0.0);
  else
    EXPECT_GT(moved, 0.0);
}

TEST_P(Modes, EqualDenseAlgebra) {
  for (int n = 0; n <= sectors / 2; ++n) {
    const CyclicModes modes = lowest(n, 20);
    const Eigen::VectorXd exact = test::generalized_eigenvalues(K(n), M(n));
    for (int k = 0; k < 20; ++k) EXPECT_NEAR(modes.eigenvalue[k] / exact[k], 1.0, 1e-9) << n << " " << k;
    EXPECT_DOUBLE_EQ(modes.frequencies()[0], std::sqrt(modes.eigenvalue[0]) / (2 * std::numbers::pi));
  }
}

TEST_P(Modes, ResidualBoundsTheError) {
  // Loose enough that there is an error to bound; at least one value must be off by more than rounding.
  constexpr double rounding = 1e-10;  // of dense algebra: the largest eigenvalue over the smallest
  double largest = 0;
  for (int n = 0; n <= sectors / 2; ++n) {
    const CyclicModes modes = lowest(n, 10, 1e-2);
    const Eigen::VectorXd exact = test::generalized_eigenvalues(K(n), M(n));
    for (int k = 0; k < 10; ++k) {
      const double error = std::abs(exact[k] / modes.eigenvalue[k] - 1);  // of 1/omega^2, over the computed one's
      EXPECT_LE(error, modes.residual[k] + rounding) << n << " " << k;
      EXPECT_LE(modes.residual[k], 1e-2);
      largest = std::max(largest, error);
    }
  }
  EXPECT_GT(largest, 10 * rounding);
}

TEST_P(Modes, AreRealForStandingWaves) {
  for (const int n : {0, sectors / 2}) EXPECT_EQ(lowest(n, 6).shape.imag().cwiseAbs().maxCoeff(), 0.0);
  EXPECT_GT(lowest(1, 6).shape.imag().cwiseAbs().maxCoeff(), 0.0);
}

TEST_P(Modes, AreTheSameEveryTime) {
  EXPECT_EQ(lowest(1, 6).shape, lowest(1, 6).shape);
}

TEST_P(Modes, AllOfThemCanBeAskedFor) {
  const int all = static_cast<int>(free_dofs());
  const CyclicModes modes = lowest(1, all);
  const Eigen::VectorXd exact = test::generalized_eigenvalues(K(1), M(1));
  for (int k = 0; k < all; ++k) EXPECT_NEAR(modes.eigenvalue[k] / exact[k], 1.0, 1e-6) << k;
}

TEST_P(Modes, RefuseToInventMore) {
  const int all = static_cast<int>(free_dofs());
  EXPECT_EQ(
      complaint<RunError>([&] { lowest(0, all + 1); }),
      "a nodal diameter has only " + std::to_string(all) + " modes, " + std::to_string(all + 1) +
          " are asked for; lower fixed_interface_modes or verification_modes, raise accuracy, or refine the mesh");
}

TEST(LowestModes, FindBothOfADoubleEigenvalue) {
  // A plain ring meshed as one piece has every travelling wave twice; a block must find both.
  test::Annulus annulus;
  annulus.sector_count = 4;
  TestRotor wheel(annulus.wheel(), {annulus.wheel().node_count() - 1});
  const SectorFactor factor(wheel.at_rest(), wheel.dofs());
  const CyclicModes modes =
      lowest_modes(CyclicSolver(factor, {wheel.dofs(), 1, 0}), wheel.mass(), ContactNodes::free, 12, tolerance);
  const Eigen::VectorXd exact =
      test::generalized_eigenvalues(test::dense(wheel.at_rest()), test::dense(wheel.mass()));
  for (int k = 0; k < 12; ++k) EXPECT_NEAR(modes.eigenvalue[k] / exact[k], 1.0, 1e-9) << k;
  int doubles = 0;
  for (int k = 1; k < 12; ++k) doubles += exact[k] / exact[k - 1] - 1 < 1e-9;
  EXPECT_GE(doubles, 3);
}

}  // namespace
}  // namespace tiprub::reduce::cyclic_modes_test
