// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/condensation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "reduce/model/hermitian_part.h"

namespace tiprub {

namespace {

/// Modes of a Hermitian pencil, ascending; real ones for real matrices, so that a standing wave stays real.
Eigen::MatrixXcd modes_of(const Eigen::MatrixXcd& K, const Eigen::MatrixXcd& M) {
  if (K.imag().isZero(0.0) && M.imag().isZero(0.0))
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K.real(), M.real())
        .eigenvectors()
        .cast<std::complex<double>>();
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd>(K, M).eigenvectors();
}

Eigen::MatrixXcd project(const Eigen::MatrixXcd& matrix, const Eigen::MatrixXcd& basis) {
  return hermitian_part(basis.adjoint() * matrix * basis);
}

}  // namespace

Eigen::VectorXd CondensedModel::natural_frequencies() const {
  return NodalDiameterModel{K, 0 * K, 0 * K, M}.natural_frequencies(0.0);
}

CondensedModel condense(const NodalDiameterModel& model, double speed, int contact_dofs, int modes) {
  const Eigen::MatrixXcd K = model.stiffness(speed);
  const Eigen::Index inner = K.rows() - contact_dofs;
  if (modes <= 0 || modes >= inner) return {K, model.M, Eigen::MatrixXcd::Identity(K.rows(), K.rows())};
  CondensedModel condensed;
  condensed.basis = Eigen::MatrixXcd::Zero(K.rows(), contact_dofs + modes);
  condensed.basis.topLeftCorner(contact_dofs, contact_dofs).setIdentity();
  condensed.basis.bottomLeftCorner(inner, contact_dofs) =  // constraint modes at this speed
      -K.bottomRightCorner(inner, inner).partialPivLu().solve(K.bottomLeftCorner(inner, contact_dofs));
  condensed.basis.bottomRightCorner(inner, modes) =
      modes_of(K.bottomRightCorner(inner, inner), model.M.bottomRightCorner(inner, inner)).leftCols(modes);
  condensed.K = project(K, condensed.basis);
  condensed.M = project(model.M, condensed.basis);
  return condensed;
}

}  // namespace tiprub
