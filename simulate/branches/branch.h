// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "simulate/response/response.h"
#include "simulate/scene/scene.h"

namespace tiprub::simulate {

struct BranchLimits {
  double speed_min, speed_max;  ///< [rad/s]
  double first_step;            ///< [1] of the speed
  int steps;                    ///< at most, to either side
};

/// Follows an orbit, stable or not, over speed to both sides by LOCA's pseudo-arclength continuation. It begins at
/// `start`, a state of SymmetricMap at `speed` [rad/s] near the orbit. Where the contact pattern changes, the branch
/// has a kink: the step is shortened until Newton's method converges. Where that fails, the branch ends and gives the
/// reason. Raises NoMotion if there is no orbit near the start. Uses two threads, one for each side.
OrbitBranch follow_branch(const Scene& scene, double speed, int steps_per_revolution, const Eigen::VectorXd& start,
                          const BranchLimits& limits);

}  // namespace tiprub::simulate
