// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/scene/scheme.h"

#include <Eigen/Dense>

namespace tiprub {

/// One step of a modal coordinate, q+ = a q - b q- + c f, f the modal force at the middle instant. Arrays over modes.
/// For any member of this family a step is, with the modified mass mu = h^2 (1 + b) / (2 c) and the damping
/// d = h (1 - b) / c,
///   mu (q+ - 2 q + q-)/h^2 + d (q+ - q-)/(2 h) + omega^2 q = f,   omega^2 = (1 - a + b)/c,
/// which is what energy_audit counts.
struct StepCoefficients {
  Eigen::ArrayXd a;  ///< [1]
  Eigen::ArrayXd b;  ///< [1]
  Eigen::ArrayXd c;  ///< [s^2], never negative
};

/// What a scheme needs beside the modes and the step.
struct SchemeOptions {
  Scheme scheme = Scheme::trigonometric;
  double theta = 0.5;              ///< [1] of Moreau-Jean, 1/2 .. 1: 1/2 conserves energy, more damps
  double penalty_stiffness = 100;  ///< [1] of penalty, in tip stiffnesses
};

/// Arrays over modes: omega [rad/s] >= 0, damping_ratio [1] >= 0; step h [s]. The first `moving` modes have mass, the
/// others none (only residual flexibility has such).
StepCoefficients step_coefficients(const SchemeOptions& options, const Eigen::ArrayXd& omega,
                                   const Eigen::ArrayXd& damping_ratio, double step, Eigen::Index moving);

/// Exact free flight of what the step resolves; c such that a constant force ends in its static deflection:
///   a = 2 e^{-z w h} cos(y), b = e^{-2 z w h}, c = (1 - a + b)/w^2,   y = min(w sqrt(1 - z^2) h, 2.4)
/// (cosh of the whole angle for z > 1; c = h^2 at w = 0). Without the bound on y (Gautschi) modes near w h = 2 pi
/// would lose their compliance, c = 0, and blunt every impact: on a wheel with light tips the error of the settled
/// motion was 6e-2 where it is 2e-3 with it. A mode beyond the bound swings too slowly, with the right compliance and
/// decay.
StepCoefficients trigonometric(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step);

/// The paper's eq. 13 in modal coordinates, D modal:
///   a = (2 - w^2 h^2)/(1 + z w h), b = (1 - z w h)/(1 + z w h), c = h^2/(1 + z w h).
StepCoefficients central_differences(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step);

/// Trigonometric for the first `moving` modes. A mode beyond them is its static deflection under the force of the
/// step, q+ = f/w^2 (a = b = 0): high modes have mass only to make the step short or the impact blunt, and their
/// compliance is what a closed node feels (residual flexibility; massless boundaries, Monjaraz-Tec, Gross, Krack
/// 2022). Another model than the whole one. Costs no free flight for these modes, and keeps W of full rank whatever
/// is kept.
/// Raises NoMotion if a mode beyond `moving` has no stiffness.
StepCoefficients residual_flexibility(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step,
                                      Eigen::Index moving);

/// The theta method q+ = q + h (theta v+ + (1 - theta) v), with forces of the same weights, its velocity eliminated
/// (exactly: trace and determinant of its free step):
///   D = 1 + theta^2 w^2 h^2 + 2 theta z w h,
///   a = 2 - 1/theta + (1/theta - theta w^2 h^2)/D,   b = 1 - 1/theta + (1/theta + (1 - theta) w^2 h^2)/D,
///   c = h^2/D,
/// driven by theta lambda_q + (1 - theta) lambda_{q-1}. No step limit; for theta > 1/2 it damps what it shouldn't.
StepCoefficients moreau_jean(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step,
                             double theta);

}  // namespace tiprub
