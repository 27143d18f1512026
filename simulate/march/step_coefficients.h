// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/motion/scene_choices.h"

#include <Eigen/Dense>

namespace tiprub::simulate {

/// The coefficients of one step of a modal coordinate q and of its increment d = q - q-, with the modal force f at
/// the middle instant:
///   d+ = d - r d - k q + c f,   q+ = q + d+.
/// The equivalent form q+ = a q - b q- + c f, with a = 2 - r - k and b = 1 - r, would lose digits: those of the
/// velocity, because q+ - q is only of the order omega h of q, and those of r and k, which are of the orders omega h
/// and (omega h)^2.
///
/// Any step of this family is a central difference with the modified mass m_h = h^2 (2 - r)/(2 c) and the damping eta
/// = h r/c,
///   m_h (q+ - 2 q + q-)/h^2 + eta (q+ - q-)/(2 h) + omega^2 q = f,   omega^2 = k/c,
/// from which EnergyAudit derives its balance. Arrays are over modes.
struct StepCoefficients {
  Eigen::ArrayXd r;  ///< [1] share of the increment that damping takes
  Eigen::ArrayXd k;  ///< [1] omega^2 c
  Eigen::ArrayXd c;  ///< [s^2], never negative
};

/// The options of a scheme other than modes and step.
struct SchemeOptions {
  Scheme scheme = Scheme::trigonometric;
  double theta = 0.5;  ///< [1] of Moreau-Jean, 1/2 .. 1: 1/2 conserves energy, larger values damp
};

/// `omega` [rad/s] >= 0 and `damping_ratio` [1] >= 0 are arrays over modes; `step` is h [s]. The first `moving` modes
/// have mass. Only residual flexibility has modes without mass; it raises NoMotion if one of them has no stiffness.
StepCoefficients step_coefficients(const SchemeOptions& options, const Eigen::ArrayXd& omega,
                                   const Eigen::ArrayXd& damping_ratio, double step, Eigen::Index moving);

}  // namespace tiprub::simulate
