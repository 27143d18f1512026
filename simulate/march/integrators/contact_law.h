// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <memory>
#include <vector>

#include "simulate/march/contact_impulses.h"

namespace tiprub {

/// What gives the contact forces of a step. All speak of gaps only, so that the casing's motion needs no velocity.
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;

  /// From the gaps at t_q and those of the free step to t_{q+1} to the latter under the forces found. Whether there
  /// are any. `penetrates`: whether a free gap is negative.
  virtual bool step(const Eigen::VectorXd& gap_before, Eigen::VectorXd& gap, bool penetrates) = 0;

  /// [N] at t_q along -normal, zero for open nodes.
  virtual const Eigen::VectorXd& multipliers() const = 0;
  /// [m] what they add to the gaps, W lambda.
  virtual const Eigen::VectorXd& correction() const = 0;
  /// Indices of the nodes that have a force, ascending.
  virtual const std::vector<int>& closed() const = 0;
  virtual std::int64_t factorizations() const { return 0; }
  virtual std::int64_t fallbacks() const { return 0; }
};

/// 0 <= lambda perpendicular to g+ >= 0, or the paper's rule: the force at t_q closes the gap at t_{q+1}.
std::unique_ptr<ContactLaw> position_contact(const Eigen::MatrixXd& compliance, ContactRule rule);

/// Moreau-Jean: the gap rate G = h dg/dt follows g+ = g + theta G+ + (1 - theta) G, and for nodes with g + G/2 <= 0
///   0 <= lambda perpendicular to G+ >= 0,   G+ = G_free + W lambda,
/// an inelastic impact on velocities. Positions are nobody's constraint: a node may penetrate by about h times its
/// approaching speed, and stays there until it is pulled off.
std::unique_ptr<ContactLaw> velocity_contact(const Eigen::MatrixXd& compliance, double theta);

/// lambda = kappa max(0, -g), kappa [N/m], explicit: the force of a step is known before it. No system to solve, but
/// the spring raises omega_max (see penalised_omega_max) and the node penetrates by lambda/kappa.
std::unique_ptr<ContactLaw> penalty_contact(const Eigen::MatrixXd& compliance, double stiffness);

}  // namespace tiprub
