// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulate/branches/exact_orbit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "reduce/model/dense_eigen.h"

namespace tiprub::simulate::testing {

namespace {

constexpr int looks = 400;  // a revolution: between two of them the spring is met or left at most once

class Oscillator {
 public:
  Oscillator(const OneSidedSpring& plan, double speed)
      : plan_(plan), speed_(speed), decay_(plan.damping * std::sqrt(plan.stiffness / plan.mass)) {}

  double revolution() const { return 2 * std::numbers::pi / speed_; }
  /// [m] that the second spring is pressed by, at the instant t.
  double pressed(const Eigen::Vector2d& z, double t) const {
    return z[0] + plan_.amplitude * std::cos(speed_ * t) - plan_.clearance;
  }
  /// [m] of the second spring's free end.
  double free_end(const Eigen::Vector2d& z, double t) const { return z[0] - std::max(0.0, pressed(z, t)); }

  /// e^{A t}, and the motion from z at `from` to `to` with the second spring held or free.
  Eigen::Matrix2d transition(bool held, double t) const {
    const double square = stiffness(held) / plan_.mass, omega = std::sqrt(square - decay_ * decay_);
    const double s = std::sin(omega * t) / omega, c = std::cos(omega * t);
    Eigen::Matrix2d step;
    step << c + decay_ * s, s, -square * s, c - decay_ * s;
    return std::exp(-decay_ * t) * step;
  }
  Eigen::Vector2d moved(bool held, const Eigen::Vector2d& z, double from, double to) const {
    if (!held) return transition(false, to - from) * z;
    return forced(to) + transition(true, to - from) * (z - forced(from));
  }

  /// z a revolution later and its derivative, where `visit(z, t)` sees `count` even instants, the first one included.
  template <class Visit>
  Eigen::Vector2d map(Eigen::Vector2d z, Eigen::Matrix2d& monodromy, int count, const Visit& visit) const {
    monodromy.setIdentity();
    for (int i = 0; i < count; ++i) {
      const double from = revolution() * i / count;
      visit(z, from);
      z = through_changes(z, from, revolution() * (i + 1) / count, monodromy);
    }
    return z;
  }

 private:
  double stiffness(bool held) const { return plan_.stiffness + (held ? plan_.one_sided : 0); }
  /// The forced motion while the second spring is held.
  Eigen::Vector2d forced(double t) const {
    using Complex = std::complex<double>;
    const Complex i(0, 1), dynamic(stiffness(true) - plan_.mass * speed_ * speed_, 2 * decay_ * plan_.mass * speed_);
    const Complex swing = -plan_.one_sided * plan_.amplitude / dynamic * std::exp(i * speed_ * t);
    return {plan_.one_sided * plan_.clearance / stiffness(true) + swing.real(), (i * speed_ * swing).real()};
  }
  /// The force is continuous where the spring is met and left: so is the derivative of the motion.
  Eigen::Vector2d through_changes(Eigen::Vector2d z, double from, double to, Eigen::Matrix2d& monodromy) const {
    const double middle = from + (to - from) / 1e6;
    bool held = pressed(z, from) > 0;
    if (std::abs(pressed(z, from)) < 1e-14 * plan_.clearance)
      held = pressed(moved(held, z, from, middle), middle) > 0;
    while (from < to) {
      double until = to;
      if ((pressed(moved(held, z, from, to), to) > 0) != held) {
        double before = from;
        for (int i = 0; i < 80; ++i) {
          const double half = (before + until) / 2;
          ((pressed(moved(held, z, from, half), half) > 0) == held ? before : until) = half;
        }
      }
      z = moved(held, z, from, until);
      monodromy = transition(held, until - from) * monodromy;
      from = until;
      held = !held;
    }
    return z;
  }

  OneSidedSpring plan_;
  double speed_, decay_;
};

/// Orbits as points (start by clearance and by clearance times frequency, speed by frequency).
class OrbitCurve {
 public:
  explicit OrbitCurve(const OneSidedSpring& plan)
      : plan_(plan),
        frequency_(std::sqrt(plan.stiffness / plan.mass)),
        unit_(plan.clearance, plan.clearance * frequency_) {}

  double speed(const Eigen::Vector3d& x) const { return x[2] * frequency_; }
  Eigen::Vector3d point(const Eigen::Vector2d& start, double speed) const {
    Eigen::Vector3d x;
    x << start.cwiseQuotient(unit_), speed / frequency_;
    return x;
  }
  /// F(x) - x, its derivative by the start, and the determinant of that.
  Eigen::Vector2d residual(const Eigen::Vector3d& x, Eigen::Matrix2d& derivative) const {
    const Eigen::Vector2d z = x.head<2>().cwiseProduct(unit_);
    Eigen::Matrix2d monodromy;
    const Eigen::Vector2d image = Oscillator(plan_, speed(x)).map(z, monodromy, looks, [](const auto&, double) {});
    derivative = unit_.cwiseInverse().asDiagonal() * monodromy * unit_.asDiagonal();
    derivative -= Eigen::Matrix2d::Identity();
    return (image - z).cwiseQuotient(unit_);
  }
  Eigen::Matrix<double, 2, 3> derivative(const Eigen::Vector3d& x) const {
    constexpr double little = 1e-6;
    Eigen::Matrix2d by_start, unused;
    residual(x, by_start);
    const Eigen::Vector3d change = little * Eigen::Vector3d::UnitZ();
    Eigen::Matrix<double, 2, 3> whole;
    whole << by_start, (residual(x + change, unused) - residual(x - change, unused)) / (2 * little);
    return whole;
  }
  /// Newton's method on the plane across `tangent`. Whether it converged.
  bool correct(const Eigen::Vector3d& tangent, Eigen::Vector3d& x) const {
    const Eigen::Vector3d guess = x;
    for (int i = 0; i < 20; ++i) {
      Eigen::Matrix2d unused;
      Eigen::Matrix3d whole;
      Eigen::Vector3d right;
      whole << derivative(x), tangent.transpose();
      right << residual(x, unused), tangent.dot(x - guess);
      const Eigen::Vector3d step = whole.partialPivLu().solve(right);
      x -= step;
      if (step.norm() < 1e-11) return true;
    }
    return false;
  }
  double determinant(const Eigen::Vector3d& x) const {
    Eigen::Matrix2d by_start;
    residual(x, by_start);
    return by_start.determinant();
  }

 private:
  OneSidedSpring plan_;
  double frequency_;
  Eigen::Vector2d unit_;
};

/// [rad/s] of the fold between x, and x + step tangent corrected.
double fold_between(const OrbitCurve& curve, const Eigen::Vector3d& x, const Eigen::Vector3d& tangent, double step) {
  double low = 0, high = step;
  const bool sign = curve.determinant(x) > 0;
  Eigen::Vector3d at = x;
  for (int i = 0; i < 50; ++i) {
    const double half = (low + high) / 2;
    at = x + half * tangent;
    if (!curve.correct(tangent, at)) break;
    ((curve.determinant(at) > 0) == sign ? low : high) = half;
  }
  return curve.speed(at);
}

}  // namespace

ExactOrbit exact_orbit(const OneSidedSpring& plan, double speed, const Eigen::Vector2d& start, int samples) {
  const OrbitCurve curve(plan);
  Eigen::Vector3d x = curve.point(start, speed);
  if (!curve.correct(Eigen::Vector3d::UnitZ(), x)) return {};
  ExactOrbit orbit;
  orbit.speed = speed;
  const Oscillator oscillator(plan, speed);
  const double frequency = std::sqrt(plan.stiffness / plan.mass);
  orbit.start = {x[0] * plan.clearance, x[1] * plan.clearance * frequency};
  double low = 1, high = -1;
  Eigen::Matrix2d monodromy;
  oscillator.map(orbit.start, monodromy, samples, [&](const Eigen::Vector2d& z, double t) {
    low = std::min(low, oscillator.free_end(z, t));
    high = std::max(high, oscillator.free_end(z, t));
  });
  orbit.amplitude = (high - low) / 2;
  orbit.multiplier = general_eigenvalues(monodromy).cwiseAbs().maxCoeff();
  return orbit;
}

std::vector<double> exact_folds(const OneSidedSpring& plan, double low, double high) {
  constexpr double length = 0.02;
  const OrbitCurve curve(plan);
  std::vector<double> folds;
  Eigen::Vector3d x = curve.point(Eigen::Vector2d::Zero(), low), tangent = Eigen::Vector3d::UnitZ();
  if (!curve.correct(tangent, x)) return folds;
  while (curve.speed(x) < high) {
    Eigen::Matrix3d whole;
    whole << curve.derivative(x), tangent.transpose();
    tangent = whole.partialPivLu().solve(Eigen::Vector3d::UnitZ()).normalized();
    double step = length;
    Eigen::Vector3d next = x + step * tangent;
    while (!curve.correct(tangent, next)) {
      if ((step /= 2) < 1e-6) return {};
      next = x + step * tangent;
    }
    if (curve.determinant(x) * curve.determinant(next) < 0) folds.push_back(fold_between(curve, x, tangent, step));
    x = next;
  }
  std::sort(folds.begin(), folds.end());
  return folds;
}

}  // namespace tiprub::simulate::testing
