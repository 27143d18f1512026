// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "simulate/march/contact_impulses.h"

namespace tiprub::simulate {

/// The gaps [m] of the contact nodes at t_{q-1}, at t_q, and at t_{q+1} after the step without its contact forces.
struct GapHistory {
  const Eigen::VectorXd &before, &now, &next;
};

/// The free motion of a node after an impulse. S(x) is its displacement x steps after the impulse, if this gave it
/// the velocity of one unit of length per step. It is that of one mode with the mean coefficients <r> and <k>,
/// weighted by the shares of the modes in W:
///   S(x) = e^{-rho x/2} sin(phi x)/phi,   e^{-rho} = 1 - <r>,   2 e^{-rho/2} cos(phi) = 2 - <r> - <k>.
/// Because S(1) = -(1 - <r>) S(-1), an impulse at an instant of the grid has the same effect as one just before or
/// just after it.
struct Recoil {
  Recoil(double r, double k);

  double at(double x) const;
  double slope(double x) const;

  double damping, stiffness;  ///< [1] <r>, <k>
  double rho, phi;
};

/// The impact of a node that meets the casing within a step, without rebound, and leaves it at once, because the
/// casing recedes faster than the node follows. A cubic through the gaps of the free motion at t_{q-1} .. t_{q+2}
/// gives the instant s [steps after t_q] at which the node arrives, and its speed V [m per step]. The impulse that
/// takes this speed away acts at s and not at an instant of the grid, and changes the free gaps by V S(x - s). A
/// force in the step therefore leaves the gap target() at t_{q+1}, and an impulse at t_{q+1} corrects the velocity to
/// that of this motion.
///
/// The error is of second order in the step. The instant s moves with the motion, as the multipliers of an orbit
/// require. A node that stays pressed after its impact does not need this: its two forces at t_q and t_{q+1} have the
/// sum and the first moment of the impulse.
class InnerImpact {
 public:
  /// The gaps [m] of a node at t_{q-1}, t_q, t_{q+1} and t_{q+2}.
  struct Gaps {
    double before, now, next, ahead;
  };
  InnerImpact(int node, const Gaps& gaps, const Recoil& recoil);

  int node() const { return node_; }
  /// [m] The gap at t_{q+1}.
  double target() const { return target_; }
  /// [m] The change of the increment of the gap at t_{q+1} by the impulse.
  double jump() const { return jump_; }
  /// [N] The impulse, as a force over a step.
  double impulse = 0;

  /// [m] The changes of target() and jump() by a change of the gaps.
  struct Change {
    double target, jump;
  };
  Change change(const Gaps& gaps) const;

 private:
  int node_;
  Recoil recoil_;
  double instant_, approach_, bend_;  ///< s [1], V [m], g''(s) [m]
  double target_, jump_;
};

/// The impacts within the steps of a march. Their impulses J at t_{q+1} can only push: with the W of the step, 0 <= J
/// perpendicular to W J - jump >= 0. The search looks at each gap of a step in which a node penetrates, and costs
/// half a step more if a node leaves at once.
class InnerImpacts {
 public:
  /// `recoils` is by node.
  InnerImpacts(const std::shared_ptr<ContactCompliance>& compliance, std::vector<Recoil> recoils);

  /// Whether the parabola through the gaps of any node predicts that it leaves at once. Remembers these nodes.
  bool foresee(const GapHistory& gaps);
  /// Finds the impacts of the nodes that foresee() remembers; `ahead` holds the gaps [m] of the free motion at
  /// t_{q+2}.
  void find(const GapHistory& gaps, const Eigen::VectorXd& ahead);
  /// Computes the impulses of the nodes with a force [N] in this step, and removes the impacts of the others.
  void push(const Eigen::VectorXd& forces);
  void clear() { all_.clear(); }

  const std::vector<InnerImpact>& all() const { return all_; }

 private:
  std::vector<Recoil> recoils_;
  ContactImpulses impulses_;
  Eigen::VectorXd jumps_;
  std::vector<int> foreseen_;
  std::vector<InnerImpact> all_;
};

}  // namespace tiprub::simulate
