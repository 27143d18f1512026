// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

#include "simulate/march/cache_lines.h"

namespace tiprub::simulate {

/// The contact compliance W [m/N] of a step. Column i holds the changes of the gaps due to a contact force of 1 N at
/// node i,
///   W(:, i) = W_N(:, i) + mu (tau_theta W_theta(:, i) + tau_m W_m(:, i)),
/// where (tau_theta, tau_m) is the direction in which the node slides over the casing. Friction acts against it with
/// mu times the contact force. Without friction W = W_N is constant, symmetric and positive semidefinite; with
/// friction it is unsymmetric.
///
/// With a gap of second order (SecondOrderTerms), a contact force also acts on the coordinates y of the node's
/// sector, with the slopes G = ds/dy of its gap, and a gap follows the displacement along the normal and G y. With
/// the rows Y of the normal displacements, B of y and S of sliding in the modes,
///   W = (Y + G B) c (Y + G B + mu tau S)^T.
/// A W that changes from step to step is never formed as a whole: a step needs only the block of its closed nodes,
/// and the effect of its forces on all gaps.
class ContactCompliance {
 public:
  /// The displacements due to unit forces: rows are the n displacements along the normals, node by node, and, with a
  /// gap of second order, the m coordinates y, sector by sector.
  struct Responses {
    Eigen::MatrixXd normal;  ///< due to forces along the normals; n x n, or (n + m) x n
    Eigen::MatrixXd
        sliding;  ///< due to forces along theta and the tip line, alternately; as many rows, 2n columns; or empty
    Eigen::MatrixXd blades;  ///< due to forces on y, padded to multiples of four per sector; (n + m) x m, or empty
    Eigen::VectorXd friction = {};  ///< [1] mu by node; only with friction
    int sectors = 1;  ///< number of sectors; with a gap of second order, each has a multiple of four nodes
  };

  /// The constant W of a march without friction and with a linear gap; n x n.
  explicit ContactCompliance(const Eigen::MatrixXd& normal) : ContactCompliance(Responses{normal, {}, {}}) {}
  explicit ContactCompliance(Responses responses);

  bool is_constant() const { return !has_friction() && !is_curved(); }
  bool has_friction() const { return responses_.sliding.size() > 0; }
  /// Whether the gap is of second order.
  bool is_curved() const { return responses_.blades.size() > 0; }
  Eigen::Index size() const { return size_; }
  const Responses& responses() const { return responses_; }
  /// Begins a step with friction. `way` holds the path of each node over the casing, of any length, along theta and
  /// along the tip line alternately; 2n values. The object keeps a reference to it.
  void slide(const Eigen::VectorXd& way);
  /// Begins a step with a gap of second order. The caller writes the slopes into the returned matrix: a row for each
  /// node, a column for each coordinate of a sector.
  Eigen::MatrixXd& tilt();
  /// [1] mu tau_theta and mu tau_m, alternately, of the nodes that were passed to block() or respond() in this step;
  /// 2n values.
  const Eigen::VectorXd& drag_ratio() const { return drag_ratio_; }
  const Eigen::MatrixXd& slopes() const { return slopes_; }
  /// The whole W in columns of stride() values, zero-padded. Only if is_constant().
  const double* data() const { return columns_.data(); }
  Eigen::Map<const Eigen::VectorXd> column(int node) const {
    return {columns_.data() + stride_ * static_cast<std::size_t>(node), size()};
  }
  std::size_t stride() const { return stride_; }
  /// Writes the block of W of some nodes (ascending indices) in columns of stride() values; without friction its
  /// lower triangle only.
  void block(const std::vector<int>& nodes, double* into);
  /// Adds to the gaps [m] a share of W times contact forces [N] on some nodes.
  void open(double share, const Eigen::VectorXd& forces, const std::vector<int>& nodes, Eigen::VectorXd& gap);
  /// [m] By how much forces along theta and the tip line, alternately [N], and forces on y [N] reduce the normal
  /// displacements and, with a gap of second order, y. Either argument may be empty.
  Eigen::VectorXd response(const Eigen::VectorXd& sliding, const Eigen::VectorXd& blades) const;
  /// Computes the effect of contact forces [N] on some nodes (ascending indices): on the gaps, opened(), and on the
  /// normal displacements and y, normal_response() and blade_response(). With a linear gap, gaps and normal
  /// displacements change by the same amounts.
  void respond(const double* forces, const std::vector<int>& nodes);
  void respond(const Eigen::VectorXd& forces, const std::vector<int>& nodes);
  /// [m] The opening of the gaps; n values, zero-padded.
  const double* opened() const { return is_curved() ? opened_.data() : response_.data(); }
  Eigen::Map<const Eigen::VectorXd> normal_response() const { return {response_.data(), size()}; }
  Eigen::Map<const Eigen::VectorXd> blade_response() const {
    return {response_.data() + size_, responses_.blades.cols()};
  }

 private:
  void point_drag(const std::vector<int>& nodes);
  /// Collects the columns of parts_ on which forces on these nodes act, and their weights.
  void weigh(const double* forces, const std::vector<int>& nodes);
  void add_narrowing();
  int sector_of(int node) const { return node / static_cast<int>(size_ / responses_.sectors); }
  /// The number of coordinates y in a sector.
  std::size_t coordinates() const { return static_cast<std::size_t>(slopes_.cols()); }

  Eigen::Index size_;
  Responses responses_;
  const double* way_ = nullptr;
  Eigen::VectorXd drag_ratio_;
  Eigen::MatrixXd slopes_;
  std::size_t stride_, tall_;              ///< n and n + m, padded to whole vectors
  kernels::Lines columns_;                 ///< W, if it is constant
  kernels::Lines parts_;                   ///< the columns of responses_, of length tall_: normal, sliding, blades
  kernels::Lines response_, opened_;       ///< [m] results of respond()
  std::vector<int> places_, sectors_;      ///< columns of parts_ in use; sectors of the closed nodes
  std::vector<double> weights_, rows_;     ///< weights of these columns; slopes of the closed nodes
  std::vector<double> forces_, on_nodes_;  ///< [N] of the last respond(), on nodes_; of the next one
  std::vector<int> nodes_;
};

}  // namespace tiprub::simulate
