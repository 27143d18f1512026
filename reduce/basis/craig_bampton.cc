// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/craig_bampton.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "reduce/model/dense_eigen.h"

namespace tiprub::reduce {

namespace {

constexpr double dependence_tolerance = 1e-10;  // of a unit direction, in squared stiffness norm

}  // namespace

CraigBamptonBasis::CraigBamptonBasis(const CyclicTransformation& transform, const SymmetricMatrix& mass,
                                     std::vector<const SymmetricMatrix*> stiffness,
                                     const Eigen::MatrixXcd& constraint_modes)
    : transform_(transform),
      mass_(mass),
      stiffness_(std::move(stiffness)),
      contact_dofs_(constraint_modes.cols()),
      stiffness_products_(stiffness_.size()) {
  join(constraint_modes);  // eq. 9, left column: (I, Psi_s(0))
}

void CraigBamptonBasis::append(const Eigen::MatrixXcd& shapes) {
  if (shapes.cols() == 0) return;
  const Eigen::MatrixXcd loads = transform_.apply(*stiffness_.front(), shapes);
  const Eigen::VectorXd scale = shapes.conjugate().cwiseProduct(loads).colwise().sum().real().unaryExpr(
      [](double square) { return square > 0 ? 1 / std::sqrt(square) : 0.0; });  // 0 where speed changed nothing
  const auto known = raw_.rightCols(raw_.cols() - contact_dofs_);
  const Eigen::MatrixXcd overlap = known.adjoint() * loads;
  // The known shapes are orthonormal only up to rounding, which matters where a new shape hardly differs from them.
  const Eigen::MatrixXcd shadow =
      stiffness_products_.front().bottomRightCorner(known.cols(), known.cols()).llt().solve(overlap);
  const Eigen::MatrixXcd gram =
      scale.asDiagonal() * hermitian_part(shapes.adjoint() * loads - overlap.adjoint() * shadow) * scale.asDiagonal();
  const auto& [lengths, directions] = eigenpairs(gram);
  const Eigen::Index kept = (lengths.array() > dependence_tolerance).count();
  dropped_ += static_cast<int>(shapes.cols() - kept);
  const Eigen::MatrixXcd weights =
      scale.asDiagonal() * directions.rightCols(kept) * lengths.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  Eigen::MatrixXcd fresh = shapes * weights;
  fresh -= known * (shadow * weights);
  join(fresh);
}

void CraigBamptonBasis::join(const Eigen::MatrixXcd& shapes) {
  const Eigen::Index old = raw_.cols();
  raw_.conservativeResize(shapes.rows(), old + shapes.cols());
  raw_.rightCols(shapes.cols()) = shapes;
  const auto columns = [&](const SymmetricMatrix& matrix) -> Eigen::MatrixXcd {
    return raw_.adjoint() * transform_.apply(matrix, shapes);
  };
  for (std::size_t s = 0; s < stiffness_.size(); ++s)
    append_products(stiffness_products_[s], columns(*stiffness_[s]));
  append_products(mass_products_, columns(mass_));
}

// eq. 9, right column: Psi*, orthonormal.
void CraigBamptonBasis::orthonormalise() {
  const Eigen::Index count = raw_.cols() - contact_dofs_;
  // M z = K z / omega^2, largest last; K is nearly the identity.
  const Eigen::MatrixXcd mass = mass_products_.bottomRightCorner(count, count);
  const ComplexEigenpairs modes = eigenpairs(mass, stiffness_products_.front().bottomRightCorner(count, count));
  const Eigen::MatrixXcd ascending = modes.vectors.rowwise().reverse();
  weights_ = ascending * modes.values.reverse().cwiseSqrt().cwiseInverse().asDiagonal();
}

Eigen::MatrixXcd CraigBamptonBasis::combine(const Eigen::MatrixXcd& coefficients) const {
  Eigen::MatrixXcd all(raw_.cols(), coefficients.cols());
  all << coefficients.topRows(contact_dofs_), weights_ * coefficients.bottomRows(weights_.cols());
  return raw_ * all;
}

Eigen::MatrixXcd CraigBamptonBasis::inner_products(const Eigen::MatrixXcd& loads) const {
  const Eigen::MatrixXcd all = raw_.adjoint() * loads;
  Eigen::MatrixXcd products(size(), loads.cols());
  products << all.topRows(contact_dofs_), weights_.adjoint() * all.bottomRows(weights_.rows());
  return products;
}

// eq. 10, from the products of the raw shapes.
Eigen::MatrixXcd CraigBamptonBasis::reduced(const Eigen::MatrixXcd& products) const {
  const Eigen::Index inner = weights_.rows();
  Eigen::MatrixXcd matrix(size(), size());
  matrix.topLeftCorner(contact_dofs_, contact_dofs_) = products.topLeftCorner(contact_dofs_, contact_dofs_);
  const Eigen::MatrixXcd mixed = products.topRightCorner(contact_dofs_, inner) * weights_;
  matrix.topRightCorner(contact_dofs_, weights_.cols()) = mixed;
  matrix.bottomLeftCorner(weights_.cols(), contact_dofs_) = mixed.adjoint();
  matrix.bottomRightCorner(weights_.cols(), weights_.cols()) =
      hermitian_part(weights_.adjoint() * products.bottomRightCorner(inner, inner) * weights_);
  return matrix;
}

}  // namespace tiprub::reduce
