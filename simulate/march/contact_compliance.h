// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

#include "simulate/march/cache_lines.h"

namespace tiprub::simulate {

/// W [m/N] of a step: its column i holds what a contact force of 1 N at node i adds to the gaps,
///   W(:, i) = W_N(:, i) + mu (tau_theta W_theta(:, i) + tau_m W_m(:, i)),
/// where (tau_theta, tau_m) is the direction in which the node slides over the casing, and friction pushes against it
/// with mu times the contact force. Without friction W = W_N is constant, symmetric, and positive semidefinite.
/// With friction it is unsymmetric and turns with the directions of each step; only the columns that a step asks for
/// are computed, at the cost of three columns each.
class ContactCompliance {
 public:
  /// Without friction; n x n.
  explicit ContactCompliance(const Eigen::MatrixXd& normal);
  /// With friction mu. `sliding` holds the columns of W_theta and W_m in turn; n x 2n.
  ContactCompliance(const Eigen::MatrixXd& normal, Eigen::MatrixXd sliding, double friction);

  bool is_symmetric() const { return sliding_.size() == 0; }
  Eigen::Index size() const { return size_; }
  /// The columns of W_theta and W_m in turn; empty without friction.
  const Eigen::MatrixXd& sliding() const { return sliding_; }
  /// Begins a step with friction: the ways of all nodes over the casing, of any length, along theta and along the tip
  /// line in turn; 2n. Refers to them.
  void slide(const Eigen::VectorXd& way);
  /// [1] mu tau_theta and mu tau_m in turn, of the nodes that are up to date; 2n.
  const Eigen::VectorXd& drag_ratio() const { return drag_ratio_; }
  /// Brings the columns of these nodes up to date.
  void refresh(const std::vector<int>& nodes) {
    if (!is_symmetric())
      for (const int node : nodes) refresh(node);
  }
  /// The whole matrix in columns of stride() values, a whole number of vectors.
  const double* data() const { return columns_.data(); }
  std::size_t stride() const { return stride_; }
  Eigen::Map<const Eigen::VectorXd> column(int node) const {
    return {columns_.data() + stride_ * static_cast<std::size_t>(node), size()};
  }
  Eigen::Map<const Eigen::VectorXd> fresh_column(int node) {
    if (!is_symmetric()) refresh(node);
    return column(node);
  }

 private:
  void refresh(int node);

  Eigen::Index size_;
  Eigen::MatrixXd sliding_;
  double friction_ = 0;
  const double* way_ = nullptr;
  Eigen::VectorXd drag_ratio_;
  std::size_t stride_;
  kernels::Lines columns_;
  kernels::Lines parts_;        ///< with friction W_N, W_theta and W_m of node after node, in columns of `stride_`
  std::vector<char> is_fresh_;  ///< by node, in this step
};

}  // namespace tiprub::simulate
