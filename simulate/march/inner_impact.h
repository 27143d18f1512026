// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "simulate/march/contact_impulses.h"

namespace tiprub::simulate {

/// The gaps [m] of contact nodes at t_{q-1}, at t_q and after the step to t_{q+1} without its contact forces.
struct GapHistory {
  const Eigen::VectorXd &before, &now, &next;
};

/// How a node goes on with a velocity of one length a step, x steps after it got it from an impulse: as the mean of
/// the modes, weighted with their share of W,
///   S(x) = e^{-rho x/2} sin(phi x)/phi,   e^{-rho} = 1 - <r>,   2 e^{-rho/2} cos(phi) = 2 - <r> - <k>,
/// so that S(1) = -(1 - <r>) S(-1): an impulse at an instant of the grid acts as one just before or just after it.
struct Recoil {
  Recoil(double r, double k);

  double at(double x) const;
  double slope(double x) const;

  double damping, stiffness;  ///< [1] <r>, <k>
  double rho, phi;
};

/// A node that meets the casing within a step, without rebound, and leaves it at once because the casing draws away
/// faster than the node follows. A cubic through the gaps of the free motion at t_{q-1} .. t_{q+2} gives the instant
/// s [steps from t_q] at which the node arrives, and its speed V [m a step]. The impulse that takes V away acts at s
/// and not at an instant of the grid: the free gaps change by V S(x - s). So a force in the step leaves target() at
/// t_{q+1}, and an impulse at t_{q+1} the velocity of that motion. The error is of second order in the step, and s
/// moves with the motion, as it must for the multipliers of an orbit. A node that is pressed after its impact needs
/// none of this: its two forces at t_q and t_{q+1} have the impulse and the first moment of its impact.
class InnerImpact {
 public:
  /// The four gaps of a node.
  struct Gaps {
    double before, now, next, ahead;
  };
  InnerImpact(int node, const Gaps& gaps, const Recoil& recoil);

  int node() const { return node_; }
  /// [m] the gap at t_{q+1}.
  double target() const { return target_; }
  /// [m] by which the impulse changes the gap's increment at t_{q+1}.
  double jump() const { return jump_; }
  /// [N] over a step.
  double impulse = 0;

  /// [m] The changes of target() and jump() with those of the gaps.
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

/// The inner impacts of a march, step by step. Their impulses J at t_{q+1} only push: with the W of a step,
/// 0 <= J perpendicular to W J - jump >= 0. The search costs a look at each gap where a node penetrates, and half a
/// step where one leaves at once.
class InnerImpacts {
 public:
  /// `recoils` is by node.
  InnerImpacts(const std::shared_ptr<ContactCompliance>& compliance, std::vector<Recoil> recoils);

  /// Whether a node seems to leave at once, by the parabola through its gaps.
  bool foresee(const GapHistory& gaps);
  /// Finds the impacts of the nodes foreseen; `ahead`: the gaps [m] of the free motion at t_{q+2}.
  void find(const GapHistory& gaps, const Eigen::VectorXd& ahead);
  /// Finds the impulses of the nodes with a force [N] in this step, and forgets the others.
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
