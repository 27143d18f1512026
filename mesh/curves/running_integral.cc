// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/curves/running_integral.h"

#include <algorithm>
#include <cmath>

#include "mesh/cells/gauss_points.h"

namespace tiprub {

namespace {

constexpr int panels = 64;
constexpr int newton_steps = 20;
constexpr double newton_tolerance = 1e-15;  // of the interval's length, 1

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

}  // namespace tiprub
