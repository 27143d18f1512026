// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/motion/scene_choices.h"

#include <Eigen/Dense>

namespace tiprub::simulate {

/// One step of a modal coordinate q and of its increment d = q - q-, f the modal force at the middle instant:
///   d+ = d - r d - k q + c f,   q+ = q + d+.   Arrays over modes.
/// This is q+ = a q - b q- + c f with a = 2 - r - k and b = 1 - r. That form would lose the digits of the velocity,
/// of which q+ - q holds a share omega h only, and those of k and r, which are of the order (omega h)^2 and omega h.
/// For any member of this family a step is, with the modified mass mu = h^2 (2 - r) / (2 c) and the damping
/// eta = h r / c,
///   mu (q+ - 2 q + q-)/h^2 + eta (q+ - q-)/(2 h) + omega^2 q = f,   omega^2 = k/c,
/// from which EnergyAudit derives its balance.
struct StepCoefficients {
  Eigen::ArrayXd r;  ///< [1] lost of the increment
  Eigen::ArrayXd k;  ///< [1] omega^2 c
  Eigen::ArrayXd c;  ///< [s^2], never negative
};

/// The options of a scheme beside the modes and the step.
struct SchemeOptions {
  Scheme scheme = Scheme::trigonometric;
  double theta = 0.5;  ///< [1] of Moreau-Jean, 1/2 .. 1: 1/2 conserves energy, more damps
};

/// The arrays over modes are omega [rad/s] >= 0 and damping_ratio [1] >= 0; `step` is h [s]. The first `moving` modes
/// have mass. The others have none, which only residual flexibility uses; it raises NoMotion if one of these has no
/// stiffness.
StepCoefficients step_coefficients(const SchemeOptions& options, const Eigen::ArrayXd& omega,
                                   const Eigen::ArrayXd& damping_ratio, double step, Eigen::Index moving);

}  // namespace tiprub::simulate
