// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace tiprub {

/// The two-step schemes. A new one is a file in this folder and a line in step_coefficients(). Schemes that carry a
/// velocity (Moreau-Jean), a contact law instead of a constraint (penalty) or modes without mass (residual
/// flexibility) enter here as well: what they change of the step is the free flight and the compliance c.
enum class Scheme {
  trigonometric,        ///< exact in free flight and in statics (Gautschi 1961); no step limit
  central_differences,  ///< the paper's eq. 13; holds for h omega_max < 2
};

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

/// Arrays over modes: omega [rad/s] >= 0, damping_ratio [1] >= 0; step h [s].
StepCoefficients step_coefficients(Scheme scheme, const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio,
                                   double step);

/// Exact free flight; c such that a constant force ends in its static deflection:
///   a = 2 e^{-z w h} cos(w sqrt(1 - z^2) h), b = e^{-2 z w h}, c = (1 - a + b)/w^2   (cosh for z > 1; c = h^2 at w =
///   0).
StepCoefficients trigonometric(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step);

/// The paper's eq. 13 in modal coordinates, D modal:
///   a = (2 - w^2 h^2)/(1 + z w h), b = (1 - z w h)/(1 + z w h), c = h^2/(1 + z w h).
StepCoefficients central_differences(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step);

}  // namespace tiprub
