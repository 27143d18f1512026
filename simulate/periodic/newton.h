// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>

#include "simulate/periodic/periodic_map.h"
#include "simulate/periodic/recycled_gmres.h"

namespace tiprub {

struct NewtonLimits {
  double tolerance;     ///< [1] of |x|: the last whole Newton step is smaller
  int iterations = 12;  ///< at most
};

struct NewtonResult {
  enum class Found { yes, no };

  Found found = Found::no;
  Eigen::VectorXd state;
  std::shared_ptr<const ContactPattern> pattern;  ///< that the map met there
  double residual = 0;                            ///< [1] |F(x) - x|/|x|
  int iterations = 0;
};

/// x = F(x) by Newton's method with a line search (NOX), its linear systems by `solver`, whose space is kept from
/// call to call. On an affine piece a step lands on its fixed point, whatever the distance, so that what is left to
/// do is to find the contact pattern that stands. Converges to orbits that repel as well. Raises what the map
/// raises.
NewtonResult find_fixed_point(PeriodicMap& map, const Eigen::VectorXd& start, const NewtonLimits& limits,
                              const std::shared_ptr<RecycledGmres>& solver);

}  // namespace tiprub
