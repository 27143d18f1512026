// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/motion/scene_choices.h"

#include <Eigen/Dense>

namespace tiprub {

/// One step of a modal coordinate, q+ = a q - b q- + c f, f the modal force at the middle instant. Arrays over modes.
/// For any member of this family a step is, with the modified mass mu = h^2 (1 + b) / (2 c) and the damping
/// d = h (1 - b) / c,
///   mu (q+ - 2 q + q-)/h^2 + d (q+ - q-)/(2 h) + omega^2 q = f,   omega^2 = (1 - a + b)/c,
/// from which EnergyAudit derives its balance.
struct StepCoefficients {
  Eigen::ArrayXd a;  ///< [1]
  Eigen::ArrayXd b;  ///< [1]
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

}  // namespace tiprub
