// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/contact_compliance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulate/march/contact_kernels.h"

namespace tiprub::simulate {

namespace {

void put_columns(const Eigen::MatrixXd& columns, std::size_t stride, double* into) {
  for (Eigen::Index i = 0; i < columns.cols(); ++i)
    std::copy_n(columns.col(i).data(), columns.rows(), into + stride * static_cast<std::size_t>(i));
}

}  // namespace

ContactCompliance::ContactCompliance(Responses responses)
    : size_(responses.normal.cols()),
      responses_(std::move(responses)),
      stride_(kernels::whole_vectors(static_cast<std::size_t>(size_))),
      tall_(kernels::whole_vectors(static_cast<std::size_t>(responses_.normal.rows()))),
      columns_(stride_ * stride_),
      is_fresh_(static_cast<std::size_t>(size_), 0) {
  put_columns(responses_.normal.topRows(size_), stride_, columns_.data());
  if (is_constant()) return;
  const auto nodes = static_cast<std::size_t>(size_), blades = static_cast<std::size_t>(responses_.blades.cols());
  parts_ = kernels::Lines(tall_ * (nodes + 2 * nodes + blades));
  put_columns(responses_.normal, tall_, parts_.data());
  put_columns(responses_.sliding, tall_, parts_.data() + tall_ * nodes);
  put_columns(responses_.blades, tall_, parts_.data() + tall_ * 3 * nodes);
  if (has_friction()) drag_ratio_ = Eigen::VectorXd::Zero(2 * size_);
  if (!is_curved()) return;
  taken_ = kernels::Lines(tall_ * nodes);
  response_ = kernels::Lines(tall_);
  slopes_ = Eigen::MatrixXd::Zero(size_, responses_.blades.cols() / responses_.sectors);
}

void ContactCompliance::slide(const Eigen::VectorXd& way) {
  way_ = way.data();
  std::fill(is_fresh_.begin(), is_fresh_.end(), 0);
}

Eigen::MatrixXd& ContactCompliance::tilt() {
  std::fill(is_fresh_.begin(), is_fresh_.end(), 0);
  return slopes_;
}

Eigen::VectorXd ContactCompliance::response(const Eigen::VectorXd& sliding, const Eigen::VectorXd& blades) const {
  Eigen::VectorXd taken = Eigen::VectorXd::Zero(responses_.normal.rows());
  if (sliding.size() > 0) taken.noalias() += responses_.sliding * sliding;
  if (blades.size() > 0) taken.noalias() += responses_.blades * blades;
  return taken;
}

void ContactCompliance::respond(const Eigen::VectorXd& forces, const std::vector<int>& nodes) {
  weights_.clear();
  for (const int node : nodes) weights_.push_back(forces[node]);
  kernels::combine_columns({taken_.data(), tall_, tall_}, nodes.data(), weights_.data(), nodes.size(),
                           response_.data());
}

void ContactCompliance::refresh(int node) {
  if (is_fresh_[node] != 0) return;
  is_fresh_[node] = 1;
  const auto nodes = static_cast<int>(size_), width = nodes / responses_.sectors;
  const auto coordinates = static_cast<int>(slopes_.cols());
  places_.assign(1, node);
  weights_.assign(1, 1.0);
  if (has_friction()) {
    const double along_theta = way_[2 * node], along_tip = way_[2 * node + 1];
    const double scale = responses_.friction[node] / std::sqrt(along_theta * along_theta + along_tip * along_tip);
    drag_ratio_[2 * node] = scale * along_theta;
    drag_ratio_[2 * node + 1] = scale * along_tip;
    places_.insert(places_.end(), {nodes + 2 * node, nodes + 2 * node + 1});
    weights_.insert(weights_.end(), {drag_ratio_[2 * node], drag_ratio_[2 * node + 1]});
  }
  for (int b = 0; b < coordinates; ++b) {
    places_.push_back(3 * nodes + node / width * coordinates + b);
    weights_.push_back(slopes_(node, b));
  }
  double* const column = columns_.data() + stride_ * static_cast<std::size_t>(node);
  double* const taken = is_curved() ? taken_.data() + tall_ * static_cast<std::size_t>(node) : column;
  kernels::combine_columns({parts_.data(), tall_, tall_}, places_.data(), weights_.data(), places_.size(), taken);
  if (!is_curved()) return;
  std::copy_n(taken, nodes, column);
  for (int sector = 0; sector < responses_.sectors; ++sector)
    kernels::add_columns(
        {slopes_.data() + sector * width, static_cast<std::size_t>(nodes), static_cast<std::size_t>(width)},
        taken + nodes + sector * coordinates, static_cast<std::size_t>(coordinates), column + sector * width);
}

}  // namespace tiprub::simulate
