// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/integrators/step_coefficients.h"
#include "simulate/motion/attempt.h"

namespace tiprub {

StepCoefficients residual_flexibility(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step,
                                      Eigen::Index moving) {
  StepCoefficients all = trigonometric(omega, damping_ratio, step);
  const Eigen::Index massless = omega.size() - moving;
  if (massless <= 0) return all;
  if (!(omega.tail(massless).minCoeff() > 0))
    throw NoMotion("a mode without stiffness can't be quasi-static; raise [simulate] modes");
  all.a.tail(massless).setZero();
  all.b.tail(massless).setZero();
  all.c.tail(massless) = omega.tail(massless).square().inverse();
  return all;
}

}  // namespace tiprub
