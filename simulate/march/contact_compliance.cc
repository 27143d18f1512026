// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/contact_compliance.h"

#include <algorithm>
#include <utility>

#include "simulate/march/contact_kernels.h"

namespace tiprub::simulate {

ContactCompliance::ContactCompliance(const Eigen::MatrixXd& normal)
    : normal_(normal),
      stride_(kernels::whole_vectors(static_cast<std::size_t>(normal.rows()))),
      columns_(stride_ * stride_),
      is_fresh_(static_cast<std::size_t>(normal.rows()), 0) {
  for (Eigen::Index i = 0; i < size(); ++i)
    std::copy_n(normal.col(i).data(), size(), columns_.data() + stride_ * static_cast<std::size_t>(i));
}

ContactCompliance::ContactCompliance(const Eigen::MatrixXd& normal, Eigen::MatrixXd sliding)
    : ContactCompliance(normal) {
  sliding_ = std::move(sliding);
}

void ContactCompliance::turn(const Eigen::VectorXd& drag_ratio) {
  drag_ratio_ = drag_ratio;
  std::fill(is_fresh_.begin(), is_fresh_.end(), 0);
}

void ContactCompliance::refresh(int node) {
  if (is_fresh_[node] != 0) return;
  Eigen::Map<Eigen::VectorXd>(columns_.data() + stride_ * static_cast<std::size_t>(node), size()) =
      normal_.col(node) + sliding_.middleCols<2>(2 * node) * drag_ratio_.segment<2>(2 * node);
  is_fresh_[node] = 1;
}

}  // namespace tiprub::simulate
