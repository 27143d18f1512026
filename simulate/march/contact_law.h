// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <memory>
#include <vector>

#include "simulate/march/marched_scene.h"

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

/// The law of a scheme: closed nodes held in place, or by the paper's rule; impulses on their velocities; springs.
/// `compliance` [m/N]: W.
std::unique_ptr<ContactLaw> contact_law(const MarchSetup& setup, const Eigen::MatrixXd& compliance);

}  // namespace tiprub
