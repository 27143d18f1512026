// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reduce/model/dense_eigen.h"

namespace tiprub {
namespace {

constexpr Eigen::Index size = 30;
constexpr double rounding = 1e-12;

template <class Matrix>
Matrix hermitian() {
  const Matrix any = Matrix::Random(size, size);
  return any + any.adjoint();
}

/// The definition, with vectors that are unit ones in B.
template <class Matrix>
void expect_solved(const Matrix& A, const Matrix& B, const Eigenpairs<typename Matrix::Scalar>& found) {
  const Matrix& X = found.vectors;
  EXPECT_LT((A * X - B * X * found.values.asDiagonal()).norm(), rounding * A.norm() * X.norm());
  EXPECT_LT((X.adjoint() * B * X - Matrix::Identity(size, size)).norm(), rounding * size);
  for (Eigen::Index i = 1; i < size; ++i) EXPECT_LE(found.values[i - 1], found.values[i]);
}

template <class Matrix>
void try_hermitian() {
  const Matrix A = hermitian<Matrix>(), any = hermitian<Matrix>(), one = Matrix::Identity(size, size);
  const Matrix B = any * any + one;
  expect_solved(A, one, eigenpairs(A));
  expect_solved(A, B, eigenpairs(A, B));
  EXPECT_LT((eigenvalues(A) - eigenpairs(A).values).norm(), rounding * A.norm());
  EXPECT_LT((eigenvalues(A, B) - eigenpairs(A, B).values).norm(), rounding * A.norm());
  EXPECT_TRUE(eigenvalues(A, Matrix(-B)).array().isNaN().all()) << "B is not positive definite";
}

TEST(DenseEigen, SolvesHermitianProblems) {
  try_hermitian<Eigen::MatrixXd>();
  try_hermitian<Eigen::MatrixXcd>();
}

TEST(DenseEigen, SolvesGeneralProblems) {
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(size, size);
  const GeneralEigenpairs found = general_eigenpairs(A);
  EXPECT_LT((A * found.vectors - found.vectors * found.values.asDiagonal()).norm(), rounding * size * A.norm());
  EXPECT_NEAR(found.vectors.colwise().norm().minCoeff(), 1, rounding);
  EXPECT_NEAR(general_eigenvalues(A).sum().real(), A.trace(), rounding * size * A.norm());
}

}  // namespace
}  // namespace tiprub
