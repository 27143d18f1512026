// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "simulate/march/inner_impact.h"

namespace tiprub::simulate {

/// The product A x of an operator A that is not available as a matrix.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// How the contact nodes slide in a step; by node.
struct Sliding {
  Eigen::VectorXd way;       ///< [m] s over the casing in the step before, along theta and along the tip line in turn
  Eigen::VectorXd turning;   ///< [N/m] mu lambda/|s|, by which a turn of s changes the drag
  Eigen::VectorXd striking;  ///< [N/m] the same for the impulses of impacts within the step
};

/// The coordinates y [m] of the blades in a step from t_q to t_{q+1} with a gap of second order, and the forces that
/// act along its slopes.
struct BladeStep {
  Eigen::VectorXd start, free;                  ///< at t_q, and at t_{q+1} without the forces of the step
  Eigen::VectorXd ahead;                        ///< after a further step without forces; empty without impacts
  Eigen::VectorXd forces, taken;                ///< [N] by node, and what they take from y at t_{q+1}
  Eigen::VectorXd impulses, taken_by_impulses;  ///< of impacts; empty without
};

/// The sets of closed nodes in consecutive steps of a march, and the impacts within steps. With these sets held
/// fixed, the march is an affine map but for the instants of the impacts, the directions of sliding, and the slopes
/// of a gap of second order.
class ContactPattern {
 public:
  static constexpr int open = -1;

  /// Adds a step. `closed`: the indices of the closed nodes, ascending.
  void add(const std::vector<int>& closed, const std::vector<InnerImpact>& impacts) {
    if (!impacts.empty()) impacts_.emplace_back(steps_.size(), impacts);
    if (closed.empty()) {
      steps_.push_back(open);
      return;
    }
    const auto [place, is_new] = places_.try_emplace(closed, static_cast<int>(sets_.size()));
    if (is_new) sets_.push_back(closed);
    steps_.push_back(place->second);
  }

  /// Adds the sliding of the step added last, which has closed nodes.
  void add(Sliding sliding) { sliding_.push_back(std::move(sliding)); }
  /// Adds the blades of the step added last.
  void add(BladeStep blades) { blades_.push_back(std::move(blades)); }
  /// The steps since the start of the march, at the first step of this pattern.
  std::int64_t first_step = 0;
  Eigen::VectorXd blades_before;  ///< [m] y one step before the first one; empty if the gap is linear

  /// For each step the index of its set in sets(), or `open`.
  const std::vector<int>& steps() const { return steps_; }
  /// The distinct sets in the order of their first steps; no set is empty.
  const std::vector<std::vector<int>>& sets() const { return sets_; }
  /// The steps with impacts in them, ascending.
  const std::vector<std::pair<std::size_t, std::vector<InnerImpact>>>& impacts() const { return impacts_; }
  /// Of the steps with closed nodes, in their order; empty without friction.
  const std::vector<Sliding>& sliding() const { return sliding_; }
  /// Of all steps; empty if the gap is linear.
  const std::vector<BladeStep>& blades() const { return blades_; }

 private:
  std::vector<Sliding> sliding_;
  std::vector<BladeStep> blades_;
  std::vector<int> steps_;
  std::vector<std::vector<int>> sets_;
  std::map<std::vector<int>, int> places_;
  std::vector<std::pair<std::size_t, std::vector<InnerImpact>>> impacts_;
};

/// The image of a state, and the contact pattern of the way there.
struct MapImage {
  Eigen::VectorXd state;
  std::shared_ptr<const ContactPattern> pattern;
};

/// A map whose fixed points x = F(x) are steady motions. It is continuous, and affine as long as the contact pattern
/// does not change, but for what ContactPattern names. Newton's method, multipliers and branches know a march by this
/// interface only.
class PeriodicMap {
 public:
  virtual ~PeriodicMap() = default;

  /// F(x). Raises NoMotion if a contact problem has no solution.
  virtual MapImage image(const Eigen::VectorXd& state) = 0;
  /// DF times a change of the state, for a fixed contact pattern; exact as long as the pattern does not change and
  /// has no impacts.
  virtual Eigen::VectorXd tangent(const std::shared_ptr<const ContactPattern>& pattern,
                                  const Eigen::VectorXd& change) = 0;
  /// A fixed linear map near (1 - DF)^-1, for linear solvers.
  virtual Eigen::VectorXd precondition(const Eigen::VectorXd& change) { return change; }
};

}  // namespace tiprub::simulate
