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

/// x with |f - (1 - A) x| <= tolerance |f|, or the best after 200 steps, by GMRES (Saad, Schultz 1986).
/// `precondition` is a fixed linear map near (1 - A)^-1. A step costs one product with A and one with that map.
///
/// Belos has such a solver for vectors of Epetra or Tpetra only. Their libraries take 40 ms to load, four times as
/// long as the rest of the program.
Eigen::VectorXd gmres(const LinearMap& A, const LinearMap& precondition, const Eigen::VectorXd& f, double tolerance);

/// How the contact nodes slide in a step; arrays by node.
struct Sliding {
  Eigen::VectorXd way;  ///< [m] path s over the casing in the step before, along theta and the tip line alternately
  Eigen::VectorXd turning;   ///< [N/m] mu lambda/|s|: change of the drag for each change of s across s
  Eigen::VectorXd striking;  ///< [N/m] the same for the impulses of impacts within the step
};

/// The coordinates y [m] of the blades in a step from t_q to t_{q+1} with a gap of second order, and the forces that
/// act along its slopes.
struct BladeStep {
  Eigen::VectorXd start, free;                  ///< at t_q, and at t_{q+1} without the forces of the step
  Eigen::VectorXd ahead;                        ///< after one more step without forces; empty without impacts
  Eigen::VectorXd forces, taken;                ///< [N] by node, and the reduction of y at t_{q+1} by them
  Eigen::VectorXd impulses, taken_by_impulses;  ///< the same for impulses of impacts; empty without impacts
};

/// The sets of closed nodes in consecutive steps of a march, and the impacts within steps. If the sets are held
/// fixed, the march is an affine map except for the instants of impacts, the directions of sliding, and the slopes of
/// a gap of second order.
struct ContactPattern {
  static constexpr int open = -1;

  std::int64_t first_step = 0;         ///< steps from the start of the march to the first one
  Eigen::VectorXd blades_before;       ///< [m] y one step before the first one; empty if the gap is linear
  std::vector<int> steps;              ///< for each step the index of its set in `sets`, or `open`
  std::vector<std::vector<int>> sets;  ///< the distinct sets in the order of their first steps; none is empty
  std::vector<std::pair<std::size_t, std::vector<InnerImpact>>> impacts;  ///< steps with impacts in them, ascending
  std::vector<Sliding> sliding;            ///< in the steps with closed nodes, in their order; empty without friction
  std::vector<BladeStep> blades;           ///< of all steps; empty if the gap is linear
  std::map<std::vector<int>, int> places;  ///< the index of each set

  /// Adds a step. `closed` are the indices of the closed nodes, ascending.
  void add(const std::vector<int>& closed, const std::vector<InnerImpact>& inner) {
    if (!inner.empty()) impacts.emplace_back(steps.size(), inner);
    if (closed.empty()) {
      steps.push_back(open);
      return;
    }
    const auto [place, is_new] = places.try_emplace(closed, static_cast<int>(sets.size()));
    if (is_new) sets.push_back(closed);
    steps.push_back(place->second);
  }
};

/// The image of a state, and the contact pattern of the march between the two.
struct MapImage {
  Eigen::VectorXd state;
  std::shared_ptr<const ContactPattern> pattern;
};

/// A map F whose fixed points x = F(x) are steady motions. It is continuous and, as long as the contact pattern does
/// not change, affine except for what ContactPattern names. Newton's method, the multipliers and the branches use a
/// march only through this interface.
class PeriodicMap {
 public:
  virtual ~PeriodicMap() = default;

  /// F(x). Raises NoMotion if a contact problem has no solution.
  virtual MapImage image(const Eigen::VectorXd& state) = 0;
  /// The derivative DF, for a fixed contact pattern, times a change of the state; exact as long as the pattern does
  /// not change and has no impacts.
  virtual Eigen::VectorXd tangent(const std::shared_ptr<const ContactPattern>& pattern,
                                  const Eigen::VectorXd& change) = 0;
  /// A fixed linear map near (1 - DF)^-1, for linear solvers.
  virtual Eigen::VectorXd precondition(const Eigen::VectorXd& change) { return change; }
  /// A disturbance, mainly of slow modes, from which multipliers may be sought; empty: any.
  virtual Eigen::VectorXd seed() const { return {}; }
};

}  // namespace tiprub::simulate
