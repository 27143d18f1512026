// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>

namespace tiprub {

/// Takes the rounding errors out of a product T^H Y T, which is Hermitian in exact arithmetic.
inline Eigen::MatrixXcd hermitian_part(const Eigen::MatrixXcd& matrix) {
  return 0.5 * (matrix + matrix.adjoint());
}

/// Eigenvalues, ascending, and their vectors, one a column.
template <class Scalar>
struct Eigenpairs {
  Eigen::VectorXd values;
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> vectors;
};
using RealEigenpairs = Eigenpairs<double>;
using ComplexEigenpairs = Eigenpairs<std::complex<double>>;

// The dense eigenproblems of all programs, by LAPACK. If a problem can't be solved, all values are NaN.

/// A x = lambda B x of Hermitian A and B, B positive definite, of which the lower triangles are read; x^H B x = 1.
/// Without B it is the unit matrix.
RealEigenpairs eigenpairs(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B = {});
ComplexEigenpairs eigenpairs(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B = {});
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B = {});
Eigen::VectorXd eigenvalues(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B = {});

/// A x = lambda x of any real A, in no order; vectors of unit length.
struct GeneralEigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
GeneralEigenpairs general_eigenpairs(const Eigen::MatrixXd& A);
Eigen::VectorXcd general_eigenvalues(const Eigen::MatrixXd& A);

}  // namespace tiprub
