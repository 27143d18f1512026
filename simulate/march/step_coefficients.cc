// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/step_coefficients.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "simulate/motion/attempt.h"

namespace tiprub::simulate {

namespace {

// [rad] The largest angle of a mode in a step. Near 2 pi a mode would return to its start whatever force acts on it
// (c = 0), and would meet the casing as if it had no compliance. Bounds of 2.0 to 2.8 give the same error within a
// third; pi is the limit of stability.
constexpr double resolved_angle = 2.4;

struct OneMode {
  double r, k, c;
};

/// For small steps 1 - 2 e^{-x} cos(y) + e^{-2x} is a difference of nearly equal numbers, and is computed as
/// (1 - e^{-x})^2 + 4 e^{-x} sin^2(y/2).
OneMode one_mode(double omega, double ratio, double step) {
  if (omega == 0) return {0.0, 0.0, step * step};
  const double x = ratio * omega * step;
  const double exact = omega * step * std::sqrt(std::abs(1 - ratio * ratio));
  const double y = ratio <= 1 ? std::min(exact, resolved_angle) : exact;
  const double decay = std::exp(-x);
  const double half = ratio <= 1 ? std::sin(y / 2) : std::sinh(y / 2);
  const double sign = ratio <= 1 ? 1.0 : -1.0;
  const double static_share = std::expm1(-x) * std::expm1(-x) + sign * 4 * decay * half * half;
  return {-std::expm1(-2 * x), static_share, static_share / (omega * omega)};
}

/// Exact free flight of the modes that the step resolves, with c chosen such that a constant force leads to its
/// static deflection:
///   r = 1 - e^{-2 z w h}, k = 1 - 2 e^{-z w h} cos(y) + e^{-2 z w h}, c = k/w^2,   y = min(w sqrt(1 - z^2) h, 2.4)
/// (cosh of the whole angle for z > 1; c = h^2 at w = 0). Without the bound on y (Gautschi) modes near w h = 2 pi
/// would lose their compliance (c = 0), which falsifies every impact: on a wheel with light tips the error of the
/// settled motion is 6e-2 without the bound and 2e-3 with it. A mode beyond the bound oscillates too slowly, but has
/// the right compliance and decay.
StepCoefficients trigonometric(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step) {
  const Eigen::Index count = omega.size();
  StepCoefficients all{Eigen::ArrayXd(count), Eigen::ArrayXd(count), Eigen::ArrayXd(count)};
  for (Eigen::Index mode = 0; mode < count; ++mode) {
    const OneMode one = one_mode(omega[mode], damping_ratio[mode], step);
    all.r[mode] = one.r;
    all.k[mode] = one.k;
    all.c[mode] = one.c;
  }
  return all;
}

/// The paper's eq. 13 in modal coordinates, D modal:
///   a = (2 - w^2 h^2)/(1 + z w h), b = (1 - z w h)/(1 + z w h), c = h^2/(1 + z w h).
StepCoefficients central_differences(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step) {
  // eq. 13, each mode: [1/h^2 + z w/h]^-1 times (2/h^2 - w^2), (1/h^2 - z w/h), and 1 for the force of eq. 15
  const Eigen::ArrayXd angle = omega * step;
  const Eigen::ArrayXd lag = damping_ratio * angle;
  return {2 * lag / (1 + lag), angle.square() / (1 + lag), step * step / (1 + lag)};
}

/// Trigonometric for the first `moving` modes. The modes beyond them have no mass and take their static deflection
/// under the force of the step, q+ = f/w^2 (r = k = 1): a closed node feels their compliance, while their mass would
/// only shorten the step (residual flexibility; massless boundaries, Monjaraz-Tec, Gross, Krack 2022). This is a
/// different model from the full one. The modes without mass cost no free flight, and W keeps its full rank however
/// few modes have mass. Raises NoMotion if a mode beyond `moving` has no stiffness.
StepCoefficients residual_flexibility(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step,
                                      Eigen::Index moving) {
  StepCoefficients all = trigonometric(omega, damping_ratio, step);
  const Eigen::Index massless = omega.size() - moving;
  if (massless <= 0) return all;
  if (!(omega.tail(massless).minCoeff() > 0))
    throw NoMotion("a mode without stiffness must have mass; raise [simulate] modes");
  all.r.tail(massless).setOnes();
  all.k.tail(massless).setOnes();
  all.c.tail(massless) = omega.tail(massless).square().inverse();
  return all;
}

/// The theta method q+ = q + h (theta v+ + (1 - theta) v), with forces of the same weights, its velocity eliminated
/// (exactly: trace and determinant of its free step):
///   D = 1 + theta^2 w^2 h^2 + 2 theta z w h,
///   r = ((2 theta - 1) w^2 h^2 + 2 z w h)/D,   k = w^2 h^2/D,   c = h^2/D,
/// driven by theta lambda_q + (1 - theta) lambda_{q-1}. It has no step limit, and adds numerical damping for
/// theta > 1/2.
StepCoefficients moreau_jean(const Eigen::ArrayXd& omega, const Eigen::ArrayXd& damping_ratio, double step,
                             double theta) {
  const Eigen::ArrayXd angle_2 = (omega * step).square();
  const Eigen::ArrayXd lag = 2 * damping_ratio * omega * step;
  const Eigen::ArrayXd divisor = 1 + theta * theta * angle_2 + theta * lag;
  return {((2 * theta - 1) * angle_2 + lag) / divisor, angle_2 / divisor, step * step / divisor};
}

}  // namespace

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

}  // namespace tiprub::simulate
