// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace tiprub {

/// A smooth periodic function through given points. It consists of monotone cubics (Fritsch and Butland 1984, Boost's
/// pchip), never leaves the range of neighbouring points, and has a continuous first derivative. One point gives a
/// constant.
class PeriodicTable {
 public:
  PeriodicTable() = default;
  /// [1] of the period: the smallest distance of two points, which rounding could otherwise merge a period later.
  static constexpr double closest = 1e-9;
  /// Points [x, y] with x increasing by more than `closest` inside [x_0, x_0 + period).
  PeriodicTable(const std::vector<std::array<double, 2>>& points, double period);

  double operator()(double x) const;

 private:
  std::function<double(double)> cubic_;  ///< over start_ .. start_ + period_
  double start_ = 0.0;
  double period_ = 1.0;
};

}  // namespace tiprub
