// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulate/branches/one_sided_spring.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/simulate/one_sector.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double there_and_back = 1e-4;  // of the frequency: less is no fold, but the instants' roughness
constexpr int harmonics = 20, instants = 128, unknowns = 2 * harmonics + 1;

/// Fourier coefficients (mean, cosines, sines) of u over the clearance, and the speed over the mass's frequency.
class HarmonicBalance {
 public:
  explicit HarmonicBalance(const OneSidedSpring& plan) : plan_(plan), values_(instants, unknowns) {
    for (int i = 0; i < instants; ++i) {
      const double angle = 2 * std::numbers::pi * i / instants;
      values_(i, 0) = 1;
      for (int k = 1; k <= harmonics; ++k) {
        values_(i, k) = std::cos(k * angle);
        values_(i, harmonics + k) = std::sin(k * angle);
      }
    }
    coefficients_ = 2.0 / instants * values_.transpose();
    coefficients_.row(0) /= 2;
  }

  /// The balance's residual at x = (u, r), and its derivative, unknowns x (unknowns + 1).
  Eigen::VectorXd residual(const Eigen::VectorXd& x, Eigen::MatrixXd& derivative) const {
    const double r = x[unknowns], share = plan_.one_sided / plan_.stiffness;
    const Eigen::VectorXd u = x.head(unknowns);
    Eigen::MatrixXd linear = Eigen::MatrixXd::Zero(unknowns, unknowns), by_speed = linear;
    linear(0, 0) = 1;
    for (int k = 1; k <= harmonics; ++k) {
      const int c = k, s = harmonics + k;
      linear(c, c) = linear(s, s) = 1 - k * k * r * r;
      linear(c, s) = 2 * plan_.damping * k * r;
      linear(s, c) = -linear(c, s);
      by_speed(c, c) = by_speed(s, s) = -2.0 * k * k * r;
      by_speed(c, s) = 2 * plan_.damping * k;
      by_speed(s, c) = -by_speed(c, s);
    }
    Eigen::VectorXd pressed = values_ * u + values_.col(1) * (plan_.amplitude / plan_.clearance);
    pressed.array() -= 1;
    const Eigen::VectorXd closed = (pressed.array() > 0).cast<double>();
    derivative.resize(unknowns, unknowns + 1);
    derivative.leftCols(unknowns) = linear + share * coefficients_ * closed.asDiagonal() * values_;
    derivative.col(unknowns) = by_speed * u;
    return linear * u + share * coefficients_ * pressed.cwiseProduct(closed);
  }

 private:
  OneSidedSpring plan_;
  Eigen::MatrixXd values_, coefficients_;
};

/// Newton's method on the plane through `guess` across `tangent`. Whether it converged.
bool correct(const HarmonicBalance& balance, const Eigen::VectorXd& tangent, Eigen::VectorXd& x) {
  const Eigen::VectorXd guess = x;
  for (int i = 0; i < 20; ++i) {
    Eigen::MatrixXd derivative, whole(unknowns + 1, unknowns + 1);
    Eigen::VectorXd right(unknowns + 1);
    right.head(unknowns) = balance.residual(x, derivative);
    right[unknowns] = tangent.dot(x - guess);
    whole << derivative, tangent.transpose();
    const Eigen::VectorXd step = whole.partialPivLu().solve(right);
    x -= step;
    if (step.norm() < 1e-11) return true;
  }
  return false;
}

}  // namespace

ReducedModel one_sided_spring(const OneSidedSpring& plan) {
  constexpr double nearly_none = 1e-7;
  ReducedModel model = testing::one_sector();
  NodalDiameterModel only;
  Eigen::MatrixXcd K = plan.stiffness * Eigen::MatrixXcd::Identity(4, 4);
  K(0, 0) = plan.one_sided;
  K(0, 3) = K(3, 0) = -plan.one_sided;
  K(3, 3) = plan.stiffness + plan.one_sided;
  only.K.terms = {K};
  only.M = nearly_none * plan.mass * Eigen::MatrixXcd::Identity(4, 4);
  only.M(3, 3) = plan.mass;
  model.nodal_diameters = {only};
  return model;
}

std::vector<double> folds_by_harmonic_balance(const OneSidedSpring& plan, double low, double high) {
  const HarmonicBalance balance(plan);
  const double frequency = std::sqrt(plan.stiffness / plan.mass), length = 0.03;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns + 1), tangent = Eigen::VectorXd::Unit(unknowns + 1, unknowns);
  x[unknowns] = low / frequency;
  std::vector<double> folds;
  if (!correct(balance, tangent, x)) return folds;
  double direction = 1, furthest = x[unknowns];
  while (x[unknowns] * frequency < high) {
    const double ahead = direction * (x[unknowns] - furthest);
    if (ahead < -there_and_back) {
      folds.push_back(furthest * frequency);
      direction = -direction;
    }
    if (ahead > 0 || ahead < -there_and_back) furthest = x[unknowns];
    Eigen::MatrixXd derivative, whole(unknowns + 1, unknowns + 1);
    balance.residual(x, derivative);
    whole << derivative, tangent.transpose();
    tangent = whole.partialPivLu().solve(Eigen::VectorXd::Unit(unknowns + 1, unknowns)).normalized();
    double step = length;
    Eigen::VectorXd next = x + step * tangent;
    while (!correct(balance, tangent, next)) {
      if ((step /= 2) < 1e-6) return {};
      next = x + step * tangent;
    }
    x = next;
  }
  std::sort(folds.begin(), folds.end());
  return folds;
}

}  // namespace tiprub::simulate::testing
