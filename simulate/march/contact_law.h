// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <memory>
#include <vector>

#include "simulate/march/contact_compliance.h"
#include "simulate/march/marched_scene.h"

namespace tiprub::simulate {

/// A law that gives the contact forces of a step. It is expressed by gaps only, so that no velocity of the casing is
/// needed.
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;

  /// Finds the forces from the gaps at t_q and those of the free step to t_{q+1}, and updates the latter. Returns
  /// whether there are any forces. `penetrates`: whether a free gap is negative.
  virtual bool step(const Eigen::VectorXd& gap_before, Eigen::VectorXd& gap, bool penetrates) = 0;

  /// [N] the forces at t_q along -normal; zero for open nodes.
  virtual const Eigen::VectorXd& multipliers() const = 0;
  /// [m] W lambda, by which the forces change the gaps.
  virtual const Eigen::VectorXd& correction() const = 0;
  /// Indices of the nodes that have a force, ascending.
  virtual const std::vector<int>& closed() const = 0;
  virtual std::int64_t fallbacks() const { return 0; }
};

/// The law of a scheme: complementarity or the paper's rule in positions, impulses in velocities, or springs.
std::unique_ptr<ContactLaw> contact_law(const MarchSetup& setup,
                                        const std::shared_ptr<ContactCompliance>& compliance);

}  // namespace tiprub::simulate
