// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/integrators/step_coefficients.h"

namespace tiprub {

StepCoefficients central_differences(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step) {
  // eq. 13, each mode: [1/h^2 + z w/h]^-1 times (2/h^2 - w^2), (1/h^2 - z w/h), and 1 for the force of eq. 15
  const Eigen::ArrayXd angle = omega * step;
  const Eigen::ArrayXd lag = damping_ratio * angle;
  return {(2 - angle.square()) / (1 + lag), (1 - lag) / (1 + lag), step * step / (1 + lag)};
}

}  // namespace tiprub
