// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "simulate/branches/orbit_family.h"

namespace tiprub {

/// One orbit of a branch.
struct BranchPoint {
  double speed = 0;                        ///< [rad/s]
  double amplitude = 0;                    ///< [m] as SpeedResponse has it
  double multiplier = 0;                   ///< [1] largest Floquet multiplier, its magnitude a revolution
  double multiplier_uncertainty = 0;       ///< [1]
  double multiplier_angle = 0;             ///< [rad] a map, 0 .. pi
  Eigen::VectorXd state;                   ///< of the family

  bool attracts() const { return multiplier < 1; }
};

/// Orbits that hang together, in the order of their arc length.
struct Branch {
  std::vector<BranchPoint> points;
  std::string end;  ///< why it ends there

  /// [rad/s] where the branch turns back in speed: the vertex of the parabola through a point and its neighbours.
  std::vector<double> folds() const;
};

struct BranchLimits {
  double speed_min, speed_max;  ///< [rad/s]
  double first_step;            ///< [1] of the speed, to either side of which its sign points
  int steps = 100;              ///< at most
};

/// Follows a stable or unstable orbit over speed by LOCA's pseudo-arclength continuation, from a state of the family.
/// Where the contact pattern changes the branch has a kink: the step is shortened until Newton's method meets it.
/// Raises RunError if not even the first orbit is found.
Branch follow_branch(OrbitFamily& family, double speed, const Eigen::VectorXd& start, const BranchLimits& limits);

}  // namespace tiprub
