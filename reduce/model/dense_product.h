// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tiprub {

/// C += A B by the BLAS, which takes the processor's widest instructions; Eigen's own products are compiled for the
/// oldest processor.
void add_product(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::Ref<const Eigen::MatrixXd>& B,
                 Eigen::Ref<Eigen::MatrixXd> C);

}  // namespace tiprub
