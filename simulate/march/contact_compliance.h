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
/// With friction it is unsymmetric.
///
/// With a gap of second order, the force also acts on the coordinates y of the node's own blades with the slopes
/// G = ds/dy of its gap, and gaps move with G y beside the displacements along the normals (SecondOrderTerms): with
/// the rows Y, B and S of the normal displacements, of y, and of sliding,
///   W = (Y + G B) c (Y + G B + mu tau S)'.
/// What turns from step to step is computed only for the columns that a step asks for.
class ContactCompliance {
 public:
  /// What a unit force does to the normal displacements, node by node, and to the coordinates y, sector by sector.
  struct Responses {
    Eigen::MatrixXd normal;   ///< to forces along the normals; n x n, or (n + m) x n
    Eigen::MatrixXd sliding;  ///< to forces along theta and along the tip line in turn; as many rows, x 2n; or empty
    Eigen::MatrixXd blades;   ///< to forces on y; (n + m) x m, or empty
    Eigen::VectorXd friction = {};  ///< [1] mu, node by node; with sliding only
    int sectors = 1;                ///< with a gap of second order, of whole vectors of four nodes
  };

  /// Without friction, and with a gap of first order; n x n.
  explicit ContactCompliance(const Eigen::MatrixXd& normal) : ContactCompliance(Responses{normal, {}, {}}) {}
  explicit ContactCompliance(Responses responses);

  bool is_constant() const { return !has_friction() && !is_curved(); }
  bool has_friction() const { return responses_.sliding.size() > 0; }
  /// Whether the gap is of second order.
  bool is_curved() const { return responses_.blades.size() > 0; }
  Eigen::Index size() const { return size_; }
  const Responses& responses() const { return responses_; }
  /// Begins a step with friction: the ways of all nodes over the casing, of any length, along theta and along the tip
  /// line in turn; 2n. Refers to them.
  void slide(const Eigen::VectorXd& way);
  /// Begins a step with a gap of second order, and gives the place for its slopes: a row for each node, a column for
  /// each coordinate of a sector.
  Eigen::MatrixXd& tilt();
  /// [1] mu tau_theta and mu tau_m in turn, of the nodes that are up to date; 2n.
  const Eigen::VectorXd& drag_ratio() const { return drag_ratio_; }
  const Eigen::MatrixXd& slopes() const { return slopes_; }
  /// Brings the columns of these nodes up to date.
  void refresh(const std::vector<int>& nodes) {
    if (!is_constant())
      for (const int node : nodes) refresh(node);
  }
  /// The whole matrix in columns of stride() values, a whole number of vectors.
  const double* data() const { return columns_.data(); }
  std::size_t stride() const { return stride_; }
  Eigen::Map<const Eigen::VectorXd> column(int node) const {
    return {columns_.data() + stride_ * static_cast<std::size_t>(node), size()};
  }
  Eigen::Map<const Eigen::VectorXd> fresh_column(int node) {
    if (!is_constant()) refresh(node);
    return column(node);
  }
  /// What forces along theta and along the tip line in turn [N], and forces on y [N], take from the normal
  /// displacements, and with a gap of second order from y; each may be empty.
  Eigen::VectorXd response(const Eigen::VectorXd& sliding, const Eigen::VectorXd& blades) const;
  /// With a gap of second order: finds what contact forces [N] on nodes that are up to date take from the normal
  /// displacements, and from y.
  void respond(const Eigen::VectorXd& forces, const std::vector<int>& nodes);
  Eigen::Map<const Eigen::VectorXd> normal_response() const { return {response_.data(), size()}; }
  Eigen::Map<const Eigen::VectorXd> blade_response() const {
    return {response_.data() + size_, responses_.blades.cols()};
  }

 private:
  void refresh(int node);

  Eigen::Index size_;
  Responses responses_;
  const double* way_ = nullptr;
  Eigen::VectorXd drag_ratio_;
  Eigen::MatrixXd slopes_;
  std::size_t stride_, tall_;  ///< whole vectors of n and of n + m
  kernels::Lines columns_;
  kernels::Lines taken_;     ///< with a gap of second order, in columns of `tall_`: what the forces take
  kernels::Lines parts_;     ///< what responses_ hold node after node, then coordinate after coordinate, likewise
  kernels::Lines response_;  ///< of respond()
  std::vector<int> places_;  ///< of the parts of a column
  std::vector<double> weights_;
  std::vector<char> is_fresh_;  ///< by node, in this step
};

}  // namespace tiprub::simulate
