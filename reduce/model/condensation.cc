// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/condensation.h"

#include <Eigen/LU>

#include "reduce/model/dense_eigen.h"

namespace tiprub {

namespace {

template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// In this basis K has no coupling: fixed-interface modes do no work on constraint modes. Entries that are known to
/// be zero or one aren't computed.
template <class Scalar>
CondensedModel in_second_basis(const Matrix<Scalar>& K, const Matrix<Scalar>& M, Eigen::Index contact,
                               Eigen::Index modes) {
  const Eigen::Index inner = K.rows() - contact, all = contact + modes;
  const Matrix<Scalar> inner_mass = M.bottomRightCorner(inner, inner),
                       inner_contact = M.bottomLeftCorner(inner, contact);
  const Eigenpairs<Scalar> fixed = eigenpairs(Matrix<Scalar>(K.bottomRightCorner(inner, inner)), inner_mass);
  const Matrix<Scalar> constraint =
      -K.bottomRightCorner(inner, inner).partialPivLu().solve(K.bottomLeftCorner(inner, contact));
  const Matrix<Scalar> moved = inner_contact + inner_mass * constraint;

  Matrix<Scalar> basis = Matrix<Scalar>::Identity(K.rows(), all);
  basis.bottomLeftCorner(inner, contact) = constraint;
  basis.bottomRightCorner(inner, modes) = fixed.vectors.leftCols(modes);
  Matrix<Scalar> stiffness = Matrix<Scalar>::Zero(all, all), mass = Matrix<Scalar>::Identity(all, all);
  stiffness.topLeftCorner(contact, contact) =
      K.topLeftCorner(contact, contact) + K.topRightCorner(contact, inner) * constraint;
  stiffness.diagonal().tail(modes) = fixed.values.head(modes).template cast<Scalar>();
  mass.topLeftCorner(contact, contact) =
      M.topLeftCorner(contact, contact) + inner_contact.adjoint() * constraint + constraint.adjoint() * moved;
  mass.bottomLeftCorner(modes, contact) = basis.bottomRightCorner(inner, modes).adjoint() * moved;
  mass.topRightCorner(contact, modes) = mass.bottomLeftCorner(modes, contact).adjoint();
  using Complex = std::complex<double>;
  return {hermitian_part(stiffness.template cast<Complex>()), hermitian_part(mass.template cast<Complex>()),
          basis.template cast<Complex>()};
}

}  // namespace

Eigen::VectorXd CondensedModel::natural_frequencies() const {
  return NodalDiameterModel{{{K}}, M}.natural_frequencies(0.0);
}

CondensedModel condense(const NodalDiameterModel& model, double speed, int contact_dofs, int modes) {
  const Eigen::MatrixXcd K = model.stiffness(speed);
  const Eigen::Index inner = K.rows() - contact_dofs;
  if (modes <= 0 || modes >= inner) return {K, model.M, Eigen::MatrixXcd::Identity(K.rows(), K.rows())};
  if (K.imag().isZero(0.0) && model.M.imag().isZero(0.0))  // a standing wave stays real
    return in_second_basis<double>(K.real(), model.M.real(), contact_dofs, modes);
  return in_second_basis<std::complex<double>>(K, model.M, contact_dofs, modes);
}

}  // namespace tiprub
