// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>

#include "simulate/periodic/contact_pattern.h"

namespace tiprub {

/// Where a map leads, and by what contact.
struct MapImage {
  Eigen::VectorXd state;
  std::shared_ptr<const ContactPattern> pattern;
};

/// A map whose fixed points are steady motions, x = F(x): continuous, and affine as long as the contact pattern
/// stands. What Newton's method, stability and branches need to know of a march.
class PeriodicMap {
 public:
  virtual ~PeriodicMap() = default;

  /// F(x). Raises NoMotion if a contact problem has no solution.
  virtual MapImage image(const Eigen::VectorXd& state) = 0;
  /// DF times a change of the state, with a contact pattern held: exact between changes of the pattern.
  virtual Eigen::VectorXd tangent(const std::shared_ptr<const ContactPattern>& pattern,
                                  const Eigen::VectorXd& change) = 0;
};

}  // namespace tiprub
