// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/integrators/step_coefficients.h"

namespace tiprub {

StepCoefficients central_differences(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step) {
  const Eigen::ArrayXd angle = omega * step;
  const Eigen::ArrayXd lag = damping_ratio * angle;
  return {(2 - angle.square()) / (1 + lag), (1 - lag) / (1 + lag), step * step / (1 + lag)};
}

}  // namespace tiprub
