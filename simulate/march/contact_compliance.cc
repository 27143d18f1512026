// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/contact_compliance.h"

#include <algorithm>
#include <cmath>
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

ContactCompliance::ContactCompliance(const Eigen::MatrixXd& normal, Eigen::MatrixXd sliding, double friction)
    : ContactCompliance(normal) {
  sliding_ = std::move(sliding);
  friction_ = friction;
  drag_ratio_ = Eigen::VectorXd::Zero(2 * size());
}

void ContactCompliance::slide(const Eigen::VectorXd& way) {
  way_ = way.data();
  std::fill(is_fresh_.begin(), is_fresh_.end(), 0);
}

void ContactCompliance::refresh(int node) {
  if (is_fresh_[node] != 0) return;
  is_fresh_[node] = 1;
  const double along_theta = way_[2 * node], along_tip = way_[2 * node + 1];
  const double scale = friction_ / std::sqrt(along_theta * along_theta + along_tip * along_tip);
  drag_ratio_[2 * node] = scale * along_theta;
  drag_ratio_[2 * node + 1] = scale * along_tip;
  Eigen::Map<Eigen::VectorXd>(columns_.data() + stride_ * static_cast<std::size_t>(node), size()) =
      normal_.col(node) + drag_ratio_[2 * node] * sliding_.col(2 * node) +
      drag_ratio_[2 * node + 1] * sliding_.col(2 * node + 1);
}

}  // namespace tiprub::simulate
