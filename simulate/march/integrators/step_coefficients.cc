// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/integrators/step_coefficients.h"

#include <cassert>

namespace tiprub {

StepCoefficients step_coefficients(const SchemeOptions& options, const Eigen::ArrayXd& omega,
                                   const Eigen::ArrayXd& damping_ratio, double step, Eigen::Index moving) {
  switch (options.scheme) {
    case Scheme::trigonometric:
      return trigonometric(omega, damping_ratio, step);
    case Scheme::central_differences:
    case Scheme::penalty:
      return central_differences(omega, damping_ratio, step);
    case Scheme::residual_flexibility:
      return residual_flexibility(omega, damping_ratio, step, moving);
    case Scheme::moreau_jean:
      return moreau_jean(omega, damping_ratio, step, options.theta);
  }
  assert(false);
  return {};
}

}  // namespace tiprub
