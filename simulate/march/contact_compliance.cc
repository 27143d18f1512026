// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/contact_compliance.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "simulate/march/contact_kernels.h"

namespace tiprub::simulate {

ContactCompliance::ContactCompliance(const Eigen::MatrixXd& normal)
    : size_(normal.rows()),
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
  parts_ = kernels::Lines(3 * stride_ * stride_);
  for (Eigen::Index i = 0; i < size(); ++i) {
    double* own = parts_.data() + 3 * stride_ * static_cast<std::size_t>(i);
    std::copy_n(normal.col(i).data(), size(), own);
    std::copy_n(sliding_.col(2 * i).data(), size(), own + stride_);
    std::copy_n(sliding_.col(2 * i + 1).data(), size(), own + 2 * stride_);
  }
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
  const int parts[] = {3 * node, 3 * node + 1, 3 * node + 2};
  const double weights[] = {1, drag_ratio_[2 * node], drag_ratio_[2 * node + 1]};
  kernels::combine_columns({parts_.data(), stride_, stride_}, parts, weights, std::size(parts),
                           columns_.data() + stride_ * static_cast<std::size_t>(node));
}

}  // namespace tiprub::simulate
