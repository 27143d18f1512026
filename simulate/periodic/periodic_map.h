// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>

#include "simulate/periodic/contact_pattern.h"

namespace tiprub {

/// The image of a state, and the contact pattern of the way there.
struct MapImage {
  Eigen::VectorXd state;
  std::shared_ptr<const ContactPattern> pattern;
};

/// A map whose fixed points x = F(x) are steady motions. It is continuous, and affine as long as the contact pattern
/// does not change. Newton's method, multipliers and branches know a march by this interface only.
class PeriodicMap {
 public:
  virtual ~PeriodicMap() = default;

  /// F(x). Raises NoMotion if a contact problem has no solution.
  virtual MapImage image(const Eigen::VectorXd& state) = 0;
  /// DF times a change of the state, for a fixed contact pattern; exact as long as the pattern does not change.
  virtual Eigen::VectorXd tangent(const std::shared_ptr<const ContactPattern>& pattern,
                                  const Eigen::VectorXd& change) = 0;
};

}  // namespace tiprub
