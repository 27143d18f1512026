// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "reduce/model/hermitian_part.h"

namespace tiprub {

/// The matrix of products T^H Y T of shapes that grow in number: adds the columns T^H Y t of new shapes t. They end
/// in the new diagonal block.
inline void append_products(Eigen::MatrixXcd& products, const Eigen::MatrixXcd& columns) {
  const Eigen::Index old = products.cols(), more = columns.cols();
  products.conservativeResize(old + more, old + more);
  products.topRightCorner(old, more) = columns.topRows(old);
  products.bottomLeftCorner(more, old) = columns.topRows(old).adjoint();
  products.bottomRightCorner(more, more) = hermitian_part(columns.bottomRows(more));
}

}  // namespace tiprub
