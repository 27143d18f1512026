// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Dense>
#include <vector>

#include "reduce/model/dense_eigen.h"
#include "reduce/operators/cyclic_transformation.h"

namespace tiprub::reduce {

/// Extends the matrix T^H Y T when new shapes t join the shapes T. `columns` are T^H Y t; their last rows are the new
/// diagonal block.
inline void append_products(Eigen::MatrixXcd& products, const Eigen::MatrixXcd& columns) {
  const Eigen::Index old = products.cols(), more = columns.cols();
  products.conservativeResize(old + more, old + more);
  products.topRightCorner(old, more) = columns.topRows(old);
  products.bottomLeftCorner(more, old) = columns.topRows(old).adjoint();
  products.bottomRightCorner(more, more) = hermitian_part(columns.bottomRows(more));
}

/// eq. 9: one basis of one nodal diameter for all speeds. It holds the constraint modes at rest, unchanged so that
/// contact dofs stay physical, and an M-orthonormal set made from all other shapes: fixed-interface modes of
/// several speeds, changes of the constraint modes with speed (without which a thin blade that has rotated under
/// load would have large errors), and corrections for modes at other speeds. A direction is dropped if its norm in
/// the stiffness is small, never because its mass is small: light directions are the stiff ones.
///
/// The sector's matrices are applied to each shape when it is appended; all other work is on small matrices. A new
/// shape is first made orthonormal to the others in the stiffness at rest, because rounding would destroy the
/// lowest modes in small matrices of nearly dependent shapes.
class CraigBamptonBasis {
 public:
  /// `stiffness` are the sector's at the speeds that the model samples, the first one at rest; all matrices must
  /// outlive the basis. `constraint_modes` (Psi_s of eq. 8, at rest): independent x contact dofs.
  CraigBamptonBasis(const CyclicTransformation& transform, const SymmetricMatrix& mass,
                    std::vector<const SymmetricMatrix*> stiffness, const Eigen::MatrixXcd& constraint_modes);

  /// Adds shapes, independent x any number, with contact rows of zero. Call orthonormalise() afterwards.
  void append(const Eigen::MatrixXcd& shapes);
  /// Makes the generalized dofs: the modes of the small model at rest with its contact nodes held, by ascending
  /// frequency.
  void orthonormalise();

  /// Contact dofs, then generalized dofs.
  Eigen::Index size() const { return contact_dofs() + weights_.cols(); }
  Eigen::Index contact_dofs() const { return contact_dofs_; }
  /// The number of shapes that were dropped because the others already held them.
  int dropped() const { return dropped_; }
  /// eq. 10: T^H K T at a sampled speed, and T^H M T; size x size, Hermitian, real for a standing transform.
  Eigen::MatrixXcd stiffness(std::size_t sample) const { return reduced(stiffness_products_[sample]); }
  Eigen::MatrixXcd mass() const { return reduced(mass_products_); }
  /// The shapes times `coefficients` (size x any number); independent x columns.
  Eigen::MatrixXcd combine(const Eigen::MatrixXcd& coefficients) const;
  /// The inner products of the shapes with columns of loads (independent x any number); size x columns.
  Eigen::MatrixXcd inner_products(const Eigen::MatrixXcd& loads) const;
  /// All shapes; independent x size.
  Eigen::MatrixXcd shapes() const { return combine(Eigen::MatrixXcd::Identity(size(), size())); }
  const CyclicTransformation& transform() const { return transform_; }

 private:
  void join(const Eigen::MatrixXcd& shapes);
  Eigen::MatrixXcd reduced(const Eigen::MatrixXcd& products) const;

  const CyclicTransformation& transform_;
  const SymmetricMatrix& mass_;
  std::vector<const SymmetricMatrix*> stiffness_;
  Eigen::Index contact_dofs_;
  int dropped_ = 0;
  Eigen::MatrixXcd raw_;            // constraint modes, then K-orthonormal shapes; independent x any
  Eigen::MatrixXcd mass_products_;  // raw^H M raw
  std::vector<Eigen::MatrixXcd> stiffness_products_;  // raw^H K raw, by sample
  Eigen::MatrixXcd weights_;                          // raw shapes without constraint modes x generalized dofs
};

}  // namespace tiprub::reduce
