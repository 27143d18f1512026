// SPDX-License-Identifier: GPL-3.0-or-later
// One sector and its phases against the whole wheel, meshed as one piece and without any cut face.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "reduce/operators/cyclic_transformation.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::cyclic;
using test::dense;
using test::TestRotor;

constexpr double speed = 2000.0;  // [rad/s], also tried at rest

class Wheel : public ::testing::TestWithParam<int> {
 protected:
  Wheel() : sector_(test::tip_rotor(annulus())), wheel_(annulus().wheel(), {}) {}
  static test::Annulus annulus() { return test::skewed_annulus(GetParam()); }

  /// A wheel's matrix with its dofs sector by sector, in the same order in each.
  Eigen::MatrixXd sector_by_sector(const SymmetricMatrix& matrix) const {
    std::vector<int> order;
    for (const int first : wheel_.dofs().first)
      for (int d = 0; d < 3 && first >= 0; ++d) order.push_back(first + d);
    const Eigen::MatrixXd all = dense(matrix);
    return all(order, order);
  }

  TestRotor sector_, wheel_;
};
INSTANTIATE_TEST_SUITE_P(Sectors, Wheel, ::testing::Values(4, 5));

TEST_P(Wheel, EigenvaluesAreTheUnionOverNodalDiameters) {
  // Multiplicities included: once for n = 0 and N/2, twice in between (check 17).
  const int N = GetParam();
  for (const double at : {0.0, speed}) {
    const Eigen::VectorXd whole =
        test::generalized_eigenvalues(dense(wheel_.at_speed(at, Prestress::linear)), dense(wheel_.mass()));
    const SymmetricMatrix K = sector_.at_speed(at, Prestress::linear), M = sector_.mass();
    std::vector<double> joined;
    for (int n = 0; n <= N / 2; ++n) {
      const Eigen::VectorXd part =
          test::generalized_eigenvalues(cyclic(K, sector_.dofs(), N, n), cyclic(M, sector_.dofs(), N, n));
      for (const double value : part) joined.insert(joined.end(), n == 0 || 2 * n == N ? 1 : 2, value);
    }
    std::sort(joined.begin(), joined.end());
    ASSERT_EQ(static_cast<Eigen::Index>(joined.size()), whole.size());
    for (Eigen::Index k = 0; k < whole.size(); ++k) EXPECT_NEAR(joined[k] / whole[k], 1.0, 1e-9) << k;
  }
}

TEST_P(Wheel, MatricesAreBlockCirculant) {
  // Each sector couples to itself and its two neighbours, always by the same blocks (eq. 3, check 13).
  const int N = GetParam();
  for (const SymmetricMatrix& matrix : {wheel_.at_speed(speed, Prestress::linear), wheel_.mass()}) {
    const Eigen::MatrixXd Y = sector_by_sector(matrix);
    const Eigen::Index size = Y.rows() / N;
    ASSERT_EQ(size, sector_.dofs().independent());
    const double scale = Y.cwiseAbs().maxCoeff();
    for (int row = 0; row < N; ++row)
      for (int column = 0; column < N; ++column) {
        const int ahead = (column - row + N) % N;
        const Eigen::MatrixXd block = Y.block(row * size, column * size, size, size);
        EXPECT_LT((block - Y.block(0, ahead * size, size, size)).cwiseAbs().maxCoeff(), 1e-10 * scale);
        EXPECT_EQ(block.cwiseAbs().maxCoeff() > 0.0, ahead <= 1 || ahead == N - 1);
      }
  }
}

TEST_P(Wheel, FourierTransformLeavesTheSectorsOwnBlocks) {
  // eq. 4: F^H Y F is block diagonal (F complex here), and its blocks have the eigenvalues of T^H Y T (checks 14,
  // 16).
  const int N = GetParam();
  const SymmetricMatrix sector_matrix = sector_.at_speed(speed, Prestress::linear);
  const Eigen::MatrixXd Y = sector_by_sector(wheel_.at_speed(speed, Prestress::linear));
  const Eigen::Index size = Y.rows() / N;
  Eigen::MatrixXcd F(Y.rows(), Y.rows());
  for (int j = 0; j < N; ++j)
    for (int n = 0; n < N; ++n)
      F.block(j * size, n * size, size, size) =
          std::polar(1 / std::sqrt(N), 2 * std::numbers::pi * j * n / N) * Eigen::MatrixXcd::Identity(size, size);
  EXPECT_LT((F.adjoint() * F - Eigen::MatrixXcd::Identity(Y.rows(), Y.rows())).norm(), 1e-12);
  const Eigen::MatrixXcd turned = F.adjoint() * Y * F;
  const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(size, size);
  for (int row = 0; row < N; ++row)
    for (int column = 0; column < N; ++column) {
      const Eigen::MatrixXcd block = turned.block(row * size, column * size, size, size);
      if (row != column) {
        EXPECT_LT(block.norm(), 1e-10 * turned.norm());
        continue;
      }
      if (row > N / 2) continue;  // the conjugate of N - row
      const Eigen::VectorXd expected =
          test::generalized_eigenvalues(cyclic(sector_matrix, sector_.dofs(), N, row), one);
      const Eigen::VectorXd found = test::generalized_eigenvalues(block, one);
      EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-10 * expected.maxCoeff());
    }
}

TEST_P(Wheel, ThePapersRealBlocksAreTheCyclicTransformationsTwice) {
  // eq. 6, from the blocks Y_0 and Y_1 of the wheel: twice the size of T^H Y T, each eigenvalue twice.
  const int N = GetParam();
  const SymmetricMatrix sector_matrix = sector_.at_speed(speed, Prestress::linear);
  const Eigen::MatrixXd Y = sector_by_sector(wheel_.at_speed(speed, Prestress::linear));
  const Eigen::Index size = Y.rows() / N;
  const Eigen::MatrixXd Y0 = Y.topLeftCorner(size, size), Y1 = Y.block(size, 0, size, size);
  const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(size, size),
                         two = Eigen::MatrixXcd::Identity(2 * size, 2 * size);
  for (int n = 0; n <= N / 2; ++n) {
    const double angle = 2 * std::numbers::pi * n / N;
    const Eigen::MatrixXd even = Y0 + (Y1 + Y1.transpose()) * std::cos(angle);
    const Eigen::MatrixXd odd = (Y1 - Y1.transpose()) * std::sin(angle);
    Eigen::MatrixXcd real_block(2 * size, 2 * size);
    real_block << even, odd, -odd, even;
    const CyclicTransformation transform(sector_.dofs(), N, n);
    const Eigen::VectorXd expected = test::generalized_eigenvalues(transform.apply(sector_matrix, one), one);
    const Eigen::VectorXd found = test::generalized_eigenvalues(real_block, two);
    for (Eigen::Index k = 0; k < found.size(); ++k)
      EXPECT_NEAR(found[k], expected[k / 2], 1e-10 * expected[size - 1]) << n << " " << k;
  }
}

TEST_P(Wheel, StaticShapeUnderSpinIsTheSectors) {
  // Node 0 .. of the wheel are those of the sector without its upper face.
  const Eigen::Matrix3Xd whole = wheel_.static_displacement(speed), one = sector_.static_displacement(speed);
  const int shared = wheel_.mesh().node_count() / GetParam();
  EXPECT_LT((whole.leftCols(shared) - one.leftCols(shared)).norm(), 1e-10 * one.norm());
}

}  // namespace
}  // namespace tiprub::reduce
