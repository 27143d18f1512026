// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/dense_eigen.h"

#include <Eigen/Eigenvalues>
#include <limits>

namespace tiprub {

namespace {

template <class Solver>
auto values_of(const Solver& solver) {
  auto values = solver.eigenvalues();
  if (solver.info() != Eigen::Success) values.setConstant(std::numeric_limits<double>::quiet_NaN());
  return values;
}

template <class Matrix>
Eigenpairs<typename Matrix::Scalar> pairs_of(const Eigen::SelfAdjointEigenSolver<Matrix>& solver) {
  return {values_of(solver), solver.eigenvectors()};
}

template <class Matrix>
auto solved(const Matrix& A, int parts) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(A, parts);
}

template <class Matrix>
auto solved(const Matrix& A, const Matrix& B, int parts) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Matrix>(A, B, parts | Eigen::Ax_lBx);
}

constexpr int with_vectors = Eigen::ComputeEigenvectors, values_only = Eigen::EigenvaluesOnly;

}  // namespace

RealEigenpairs eigenpairs(const Eigen::MatrixXd& A) {
  return pairs_of(solved(A, with_vectors));
}
ComplexEigenpairs eigenpairs(const Eigen::MatrixXcd& A) {
  return pairs_of(solved(A, with_vectors));
}
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& A) {
  return values_of(solved(A, values_only));
}
Eigen::VectorXd eigenvalues(const Eigen::MatrixXcd& A) {
  return values_of(solved(A, values_only));
}

RealEigenpairs eigenpairs(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return pairs_of<Eigen::MatrixXd>(solved(A, B, with_vectors));
}
ComplexEigenpairs eigenpairs(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) {
  return pairs_of<Eigen::MatrixXcd>(solved(A, B, with_vectors));
}
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return values_of(solved(A, B, values_only));
}
Eigen::VectorXd eigenvalues(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) {
  return values_of(solved(A, B, values_only));
}

GeneralEigenpairs general_eigenpairs(const Eigen::MatrixXd& A) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  return {values_of(solver), solver.eigenvectors()};
}
Eigen::VectorXcd general_eigenvalues(const Eigen::MatrixXd& A) {
  return values_of(Eigen::EigenSolver<Eigen::MatrixXd>(A, false));
}

}  // namespace tiprub
