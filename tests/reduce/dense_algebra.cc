// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reduce/dense_algebra.h"

#include <Eigen/Eigenvalues>
#include <complex>
#include <numbers>
#include <random>

#include "reduce/model/dense_eigen.h"

namespace tiprub::reduce::test {

Eigen::MatrixXd dense(const SymmetricMatrix& lower) {
  Eigen::MatrixXd both = lower;
  both.triangularView<Eigen::StrictlyUpper>() = both.transpose();
  return both;
}

Eigen::MatrixXcd phase_matrix(const SectorDofs& dofs, int sector_count, int nodal_diameter) {
  const std::complex<double> phase = std::polar(1.0, 2 * std::numbers::pi * nodal_diameter / sector_count);
  Eigen::MatrixXcd T = Eigen::MatrixXcd::Zero(dofs.sector(), dofs.independent());
  for (int dof = 0; dof < dofs.interior + dofs.face; ++dof) T(dof, dof) = 1.0;
  for (int dof = 0; dof < dofs.face; ++dof) T(dofs.interior + dofs.face + dof, dofs.interior + dof) = phase;
  for (int dof = 0; dof < dofs.boundary(); ++dof)
    T(dofs.interior + 2 * dofs.face + dof, dofs.interior + dofs.face + dof) = 1.0;
  return T;
}

Eigen::MatrixXcd cyclic(const SymmetricMatrix& matrix, const SectorDofs& dofs, int sector_count, int nodal_diameter) {
  const Eigen::MatrixXcd T = phase_matrix(dofs, sector_count, nodal_diameter);
  return T.adjoint() * dense(matrix) * T;
}

Eigen::MatrixXcd project(const CyclicTransformation& transform, const SymmetricMatrix& matrix,
                         const Eigen::MatrixXcd& basis) {
  return hermitian_part(basis.adjoint() * transform.apply(matrix, basis));
}

Eigen::MatrixXd solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b) {
  return A.llt().solve(b);
}
Eigen::MatrixXcd solved(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& b) {
  return A.llt().solve(b);
}

bool is_positive_definite(const Eigen::MatrixXcd& A) {
  return A.llt().info() == Eigen::Success;
}

Eigen::VectorXd generalized_eigenvalues(const Eigen::MatrixXcd& K, const Eigen::MatrixXcd& M) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd>(K, M, Eigen::EigenvaluesOnly).eigenvalues();
}

double difference(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

Eigen::MatrixXcd arbitrary(Eigen::Index rows, Eigen::Index columns) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Eigen::MatrixXcd::NullaryExpr(rows, columns, [&] {
    const double real = uniform(generator);
    return std::complex<double>(real, uniform(generator));
  });
}

}  // namespace tiprub::reduce::test
