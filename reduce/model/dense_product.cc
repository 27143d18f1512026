// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/dense_product.h"

namespace tiprub {

void add_product(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::Ref<const Eigen::MatrixXd>& B,
                 Eigen::Ref<Eigen::MatrixXd> C) {
  C.noalias() += A * B;
}

}  // namespace tiprub
