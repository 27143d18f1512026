// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tiprub {

/// Of a product T^H Y T, which is Hermitian but for rounding.
inline Eigen::MatrixXcd hermitian_part(const Eigen::MatrixXcd& matrix) {
  return 0.5 * (matrix + matrix.adjoint());
}

}  // namespace tiprub
