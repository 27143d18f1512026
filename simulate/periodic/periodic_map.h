// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "simulate/march/inner_impact.h"

namespace tiprub::simulate {

/// The product A x of an operator A that is not available as a matrix.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// The sets of closed nodes in consecutive steps of a march, and the impacts within steps. With these sets held
/// fixed, the march is an affine map but for the instants of the impacts.
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

  /// For each step the index of its set in sets(), or `open`.
  const std::vector<int>& steps() const { return steps_; }
  /// The distinct sets in the order of their first steps; no set is empty.
  const std::vector<std::vector<int>>& sets() const { return sets_; }
  /// The steps with impacts in them, ascending.
  const std::vector<std::pair<std::size_t, std::vector<InnerImpact>>>& impacts() const { return impacts_; }

 private:
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
/// does not change, but for the instants at which impacts within steps occur. Newton's method, multipliers and
/// branches know a march by this interface only.
class PeriodicMap {
 public:
  virtual ~PeriodicMap() = default;

  /// F(x). Raises NoMotion if a contact problem has no solution.
  virtual MapImage image(const Eigen::VectorXd& state) = 0;
  /// DF times a change of the state, for a fixed contact pattern; exact as long as the pattern does not change and
  /// has no impacts.
  virtual Eigen::VectorXd tangent(const std::shared_ptr<const ContactPattern>& pattern,
                                  const Eigen::VectorXd& change) = 0;
};

}  // namespace tiprub::simulate
