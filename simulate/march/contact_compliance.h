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
/// A W that turns from step to step is never formed: a step needs the block of its closed nodes, and what its forces
/// do to all gaps.
class ContactCompliance {
 public:
  /// What a unit force does to the normal displacements, node by node, and to the coordinates y, sector by sector.
  struct Responses {
    Eigen::MatrixXd normal;   ///< to forces along the normals; n x n, or (n + m) x n
    Eigen::MatrixXd sliding;  ///< to forces along theta and along the tip line in turn; as many rows, x 2n; or empty
    Eigen::MatrixXd blades;   ///< to forces on y, whole vectors of four a sector; (n + m) x m, or empty
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
  /// [1] mu tau_theta and mu tau_m in turn, of the nodes that block() or respond() had in this step; 2n.
  const Eigen::VectorXd& drag_ratio() const { return drag_ratio_; }
  const Eigen::MatrixXd& slopes() const { return slopes_; }
  /// Without friction and second order: the whole matrix in columns of stride() values, a whole number of vectors.
  const double* data() const { return columns_.data(); }
  Eigen::Map<const Eigen::VectorXd> column(int node) const {
    return {columns_.data() + stride_ * static_cast<std::size_t>(node), size()};
  }
  std::size_t stride() const { return stride_; }
  /// Writes the block of some nodes, ascending, in columns of stride() values; without friction its lower triangle.
  void block(const std::vector<int>& nodes, double* into);
  /// Adds a share of what contact forces [N] on some nodes do to the gaps.
  void open(double share, const Eigen::VectorXd& forces, const std::vector<int>& nodes, Eigen::VectorXd& gap);
  /// What forces along theta and along the tip line in turn [N], and forces on y [N], take from the normal
  /// displacements, and with a gap of second order from y; each may be empty.
  Eigen::VectorXd response(const Eigen::VectorXd& sliding, const Eigen::VectorXd& blades) const;
  /// Finds what contact forces [N] on some nodes, ascending, do to the gaps, and what they take from the normal
  /// displacements and from y. Without a gap of second order the gaps and the normal displacements move alike.
  void respond(const double* forces, const std::vector<int>& nodes);
  void respond(const Eigen::VectorXd& forces, const std::vector<int>& nodes);
  /// [m] n values, then zeros up to a whole vector.
  const double* opened() const { return is_curved() ? opened_.data() : response_.data(); }
  Eigen::Map<const Eigen::VectorXd> normal_response() const { return {response_.data(), size()}; }
  Eigen::Map<const Eigen::VectorXd> blade_response() const {
    return {response_.data() + size_, responses_.blades.cols()};
  }

 private:
  void point_drag(const std::vector<int>& nodes);
  /// Collects the columns of parts_ that forces on nodes move, with their weights.
  void weigh(const double* forces, const std::vector<int>& nodes);
  void add_narrowing();
  int sector_of(int node) const { return node / static_cast<int>(size_ / responses_.sectors); }
  /// Of a sector.
  std::size_t coordinates() const { return static_cast<std::size_t>(slopes_.cols()); }

  Eigen::Index size_;
  Responses responses_;
  const double* way_ = nullptr;
  Eigen::VectorXd drag_ratio_;
  Eigen::MatrixXd slopes_;
  std::size_t stride_, tall_;  ///< whole vectors of n and of n + m
  kernels::Lines columns_;     ///< if W is constant
  kernels::Lines
      parts_;  ///< what responses_ hold node after node, then coordinate after coordinate, in columns of tall_
  kernels::Lines response_, opened_;       ///< of respond()
  std::vector<int> places_, sectors_;      ///< of the parts that forces move, and of nodes
  std::vector<double> weights_, rows_;     ///< of these parts, and the slopes and the drag of nodes
  std::vector<double> forces_, on_nodes_;  ///< [N] of the last respond(), on nodes_, and of the next
  std::vector<int> nodes_;
};

}  // namespace tiprub::simulate
