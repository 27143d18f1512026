// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "simulate/march/integrators/step_coefficients.h"

namespace tiprub {

namespace {

// [rad] a step. Near 2 pi a mode comes back to where it was, whatever pushed it (c = 0): it would meet the casing as
// if it had no compliance. 2.0 .. 2.8 give the same error within a third; pi is the limit of stability.
constexpr double resolved_angle = 2.4;

struct OneMode {
  double a, b, c;
};

/// 1 - a + b is a difference of nearly equal numbers for small steps; it is (1 - e^{-x})^2 + 4 e^{-x} sin^2(y/2).
OneMode one_mode(double omega, double ratio, double step) {
  if (omega == 0) return {2.0, 1.0, step * step};
  const double x = ratio * omega * step;
  const double exact = omega * step * std::sqrt(std::abs(1 - ratio * ratio));
  const double y = ratio <= 1 ? std::min(exact, resolved_angle) : exact;
  const double decay = std::exp(-x);
  const double half = ratio <= 1 ? std::sin(y / 2) : std::sinh(y / 2);
  const double sign = ratio <= 1 ? 1.0 : -1.0;
  const double static_share = std::expm1(-x) * std::expm1(-x) + sign * 4 * decay * half * half;
  return {2 * decay * (ratio <= 1 ? std::cos(y) : std::cosh(y)), decay * decay, static_share / (omega * omega)};
}

}  // namespace

StepCoefficients trigonometric(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step) {
  const Eigen::Index count = omega.size();
  StepCoefficients all{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXd(count)};
  for (Eigen::Index mode = 0; mode < count; ++mode) {
    const OneMode one = one_mode(omega[mode], damping_ratio[mode], step);
    all.a[mode] = one.a;
    all.b[mode] = one.b;
    all.c[mode] = one.c;
  }
  return all;
}

}  // namespace tiprub
