// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>

#include "simulate/periodic/periodic_map.h"

namespace tiprub::simulate {

struct NewtonLimits {
  double tolerance;     ///< [1] of |x|: bound of the last whole Newton step
  int iterations = 12;  ///< at most
};

struct NewtonResult {
  bool found = false;
  Eigen::VectorXd state;
  std::shared_ptr<const ContactPattern> pattern;  ///< of the map at the state
  double residual = 0;                            ///< [1] |F(x) - x|/|x|
  int iterations = 0;
};

/// Solves x = F(x) by Newton's method with a line search (NOX). On one affine piece of the map a single Newton step
/// leads to the fixed point from any distance; the iteration finds the right piece, that is, the contact pattern. It
/// also converges to orbits that repel. Raises what the map raises.
NewtonResult find_fixed_point(PeriodicMap& map, const Eigen::VectorXd& start, const NewtonLimits& limits);

}  // namespace tiprub::simulate
