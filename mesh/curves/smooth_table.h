// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace tiprub::mesh {

/// A smooth curve y(x) through given points that never overshoots them: the piecewise cubic of Fritsch and Carlson
/// (1980), slopes by Fritsch and Butland (1984), once continuously differentiable. One point is a constant. Outside
/// of the points the end values hold. Boost's pchip is the same curve, but it refuses fewer than four points, and
/// most tables of a blade have two or three.
class SmoothTable {
 public:
  /// At least one point; x strictly increasing.
  explicit SmoothTable(std::vector<std::array<double, 2>> points);

  double at(double x) const;
  double first_x() const { return points_.front()[0]; }
  double last_x() const { return points_.back()[0]; }

 private:
  std::vector<std::array<double, 2>> points_;
  std::vector<double> slopes_;  ///< dy/dx at each point
};

}  // namespace tiprub::mesh
