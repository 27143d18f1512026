// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/curves/meridional_curve.h"

#include <algorithm>
#include <cmath>

#include "mesh/cells/gauss_points.h"

namespace tiprub::mesh {

namespace {

constexpr int panels = 64;
constexpr int newton_steps = 20;
constexpr double newton_tolerance = 1e-15;  // of the interval's length, 1

using Control = std::array<MeridionalPoint, 4>;

MeridionalPoint derivative(const Control& control, double t) {
  const double u = 1.0 - t;
  return 3.0 * u * u * (control[1] - control[0]) + 6.0 * u * t * (control[2] - control[1]) +
         3.0 * t * t * (control[3] - control[2]);
}

MeridionalPoint position(const Control& control, double t) {
  const double u = 1.0 - t;
  return u * u * u * control[0] + 3.0 * u * u * t * control[1] + 3.0 * u * t * t * control[2] +
         t * t * t * control[3];
}

}  // namespace

RunningIntegral::RunningIntegral(std::function<double(double)> integrand)
    : integrand_(std::move(integrand)), sums_(panels + 1, 0.0) {
  for (int i = 0; i < panels; ++i)
    sums_[i + 1] = sums_[i] + piece(static_cast<double>(i) / panels, static_cast<double>(i + 1) / panels);
}

double RunningIntegral::piece(double from, double to) const {
  double sum = 0.0;
  for (const auto& [x, weight] : gauss_points(5))
    sum += weight * integrand_(0.5 * (from + to) + 0.5 * (to - from) * x);
  return 0.5 * (to - from) * sum;
}

double RunningIntegral::at(double x) const {
  const int panel = std::clamp(static_cast<int>(x * panels), 0, panels - 1);
  return sums_[panel] + piece(static_cast<double>(panel) / panels, x);
}

double RunningIntegral::inverse(double value) const {
  double x = value / total();
  for (int step = 0; step < newton_steps; ++step) {
    const double change = (value - at(x)) / integrand_(x);
    x = std::clamp(x + change, 0.0, 1.0);
    if (std::abs(change) < newton_tolerance) break;
  }
  return x;
}

MeridionalPoint operator+(MeridionalPoint a, MeridionalPoint b) {
  return {a.z + b.z, a.r + b.r};
}

MeridionalPoint operator-(MeridionalPoint a, MeridionalPoint b) {
  return {a.z - b.z, a.r - b.r};
}

MeridionalPoint operator*(double factor, MeridionalPoint a) {
  return {factor * a.z, factor * a.r};
}

double length_of(MeridionalPoint a) {
  return std::hypot(a.z, a.r);
}

double distance(MeridionalPoint a, MeridionalPoint b) {
  return std::hypot(a.z - b.z, a.r - b.r);
}

MeridionalCurve::MeridionalCurve(MeridionalPoint inlet, MeridionalPoint exit, std::array<double, 2> arms)
    : control_{inlet, inlet + MeridionalPoint{arms[0] * (exit.z - inlet.z), 0.0},
               exit - MeridionalPoint{0.0, arms[1] * (exit.r - inlet.r)}, exit},
      arc_([control = control_](double t) { return length_of(derivative(control, t)); }) {}

MeridionalPoint MeridionalCurve::at(double fraction) const {
  return position(control_, arc_.inverse(fraction * arc_.total()));
}

MeridionalPoint MeridionalCurve::unit_tangent(double fraction) const {
  const MeridionalPoint direction = derivative(control_, arc_.inverse(fraction * arc_.total()));
  return (1.0 / length_of(direction)) * direction;
}

}  // namespace tiprub::mesh
