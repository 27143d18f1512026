// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/errors.h"
#include "simulate/march/integrators/step_coefficients.h"

namespace tiprub {

StepCoefficients residual_flexibility(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step,
                                      Eigen::Index moving) {
  StepCoefficients all = trigonometric(omega, damping_ratio, step);
  const Eigen::Index rest = omega.size() - moving;
  if (rest <= 0) return all;
  if (!(omega.tail(rest).minCoeff() > 0))
    throw RunError("a mode without stiffness can't be quasi-static; raise [simulate] modes");
  all.a.tail(rest).setZero();
  all.b.tail(rest).setZero();
  all.c.tail(rest) = omega.tail(rest).square().inverse();
  return all;
}

}  // namespace tiprub
