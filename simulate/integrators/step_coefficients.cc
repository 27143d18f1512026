// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/step_coefficients.h"

namespace tiprub {

StepCoefficients step_coefficients(Scheme scheme, const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio,
                                   double step) {
  return scheme == Scheme::trigonometric ? trigonometric(omega, damping_ratio, step)
                                         : central_differences(omega, damping_ratio, step);
}

}  // namespace tiprub
