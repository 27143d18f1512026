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
      response_(tall_) {
  if (is_constant()) {
    columns_ = kernels::Lines(stride_ * stride_);
    put_columns(responses_.normal, stride_, columns_.data());
    return;
  }
  const auto nodes = static_cast<std::size_t>(size_), blades = static_cast<std::size_t>(responses_.blades.cols());
  parts_ = kernels::Lines(tall_ * (nodes + 2 * nodes + blades));
  put_columns(responses_.normal, tall_, parts_.data());
  put_columns(responses_.sliding, tall_, parts_.data() + tall_ * nodes);
  put_columns(responses_.blades, tall_, parts_.data() + tall_ * 3 * nodes);
  if (has_friction()) drag_ratio_ = Eigen::VectorXd::Zero(2 * size_);
  if (!is_curved()) return;
  opened_ = kernels::Lines(stride_);
  slopes_ = Eigen::MatrixXd::Zero(size_, responses_.blades.cols() / responses_.sectors);
}

void ContactCompliance::slide(const Eigen::VectorXd& way) {
  way_ = way.data();
  nodes_.clear();
}

Eigen::MatrixXd& ContactCompliance::tilt() {
  nodes_.clear();
  return slopes_;
}

Eigen::VectorXd ContactCompliance::response(const Eigen::VectorXd& sliding, const Eigen::VectorXd& blades) const {
  Eigen::VectorXd taken = Eigen::VectorXd::Zero(responses_.normal.rows());
  if (sliding.size() > 0) taken.noalias() += responses_.sliding * sliding;
  if (blades.size() > 0) taken.noalias() += responses_.blades * blades;
  return taken;
}

void ContactCompliance::point_drag(const std::vector<int>& nodes) {
  if (!has_friction()) return;
  for (const int node : nodes) {
    const double along_theta = way_[2 * node], along_tip = way_[2 * node + 1];
    const double scale = responses_.friction[node] / std::sqrt(along_theta * along_theta + along_tip * along_tip);
    drag_ratio_[2 * node] = scale * along_theta;
    drag_ratio_[2 * node + 1] = scale * along_tip;
  }
}

void ContactCompliance::block(const std::vector<int>& nodes, double* into) {
  if (is_constant()) {
    for (std::size_t column = 0; column < nodes.size(); ++column)
      for (std::size_t row = column; row < nodes.size(); ++row)
        into[stride_ * column + row] = columns_[stride_ * nodes[column] + nodes[row]];
    return;
  }
  point_drag(nodes);
  sectors_.clear();
  rows_.clear();
  for (const int node : nodes) {
    sectors_.push_back(sector_of(node));
    for (Eigen::Index b = 0; b < slopes_.cols(); ++b) rows_.push_back(slopes_(node, b));
  }
  const kernels::Parts parts{parts_.data(), tall_, static_cast<std::size_t>(size_), coordinates()};
  kernels::turned_block(parts, {nodes.data(), sectors_.data(), rows_.data(), drag_ratio_.data(), nodes.size()}, into,
                        stride_);
}

void ContactCompliance::weigh(const double* forces, const std::vector<int>& nodes) {
  const auto count = static_cast<int>(size_), coordinates = static_cast<int>(slopes_.cols());
  places_ = nodes;
  weights_.assign(forces, forces + nodes.size());
  if (has_friction())
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      places_.insert(places_.end(), {count + 2 * nodes[i], count + 2 * nodes[i] + 1});
      weights_.insert(weights_.end(),
                      {forces[i] * drag_ratio_[2 * nodes[i]], forces[i] * drag_ratio_[2 * nodes[i] + 1]});
    }
  int last = -1;
  for (std::size_t i = 0; i < nodes.size() && coordinates > 0; ++i) {
    if (const int sector = sector_of(nodes[i]); sector != last) {
      for (int b = 0; b < coordinates; ++b) places_.push_back(3 * count + sector * coordinates + b);
      weights_.resize(places_.size(), 0.0);
      last = sector;
    }
    double* const of_sector = weights_.data() + weights_.size() - coordinates;
    for (int b = 0; b < coordinates; ++b) of_sector[b] += forces[i] * slopes_(nodes[i], b);
  }
}

void ContactCompliance::respond(const double* forces, const std::vector<int>& nodes) {
  if (!nodes.empty() && nodes == nodes_ && std::equal(forces_.begin(), forces_.end(), forces)) return;
  nodes_ = nodes;
  forces_.assign(forces, forces + nodes.size());
  if (is_constant()) {
    kernels::combine_columns({columns_.data(), stride_, stride_}, nodes.data(), forces, nodes.size(),
                             response_.data());
    return;
  }
  point_drag(nodes);
  weigh(forces, nodes);
  kernels::combine_columns({parts_.data(), tall_, tall_}, places_.data(), weights_.data(), places_.size(),
                           response_.data());
  if (is_curved()) add_narrowing();
}

void ContactCompliance::add_narrowing() {
  const auto nodes = static_cast<std::size_t>(size_), width = nodes / static_cast<std::size_t>(responses_.sectors);
  std::copy_n(response_.data(), nodes, opened_.data());
  for (std::size_t sector = 0; sector < static_cast<std::size_t>(responses_.sectors); ++sector)
    kernels::add_columns({slopes_.data() + sector * width, nodes, width},
                         response_.data() + nodes + sector * coordinates(), coordinates(),
                         opened_.data() + sector * width);
}

void ContactCompliance::respond(const Eigen::VectorXd& forces, const std::vector<int>& nodes) {
  on_nodes_.clear();
  for (const int node : nodes) on_nodes_.push_back(forces[node]);
  respond(on_nodes_.data(), nodes);
}

void ContactCompliance::open(double share, const Eigen::VectorXd& forces, const std::vector<int>& nodes,
                             Eigen::VectorXd& gap) {
  if (is_constant()) {
    for (const int node : nodes) gap.noalias() += share * forces[node] * column(node);
    return;
  }
  respond(forces, nodes);
  gap.noalias() += share * Eigen::Map<const Eigen::VectorXd>(opened(), size_);
}

}  // namespace tiprub::simulate
