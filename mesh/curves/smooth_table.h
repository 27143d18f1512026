// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "cases/program/case_file.h"

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

/// [m] The lengths of a wheel. A length beyond ten metres was meant in millimetres.
inline const Range wheel_length{0.0, 10.0, Range::LowEnd::excluded};

/// A curve over the chord, [[fraction, value], ...] with fractions from 0 to 1, or one point for a constant. Values
/// are multiplied by the factor (degrees to radians).
SmoothTable read_chord_table(CaseTable& table, std::string_view key,
                             std::optional<std::vector<std::array<double, 2>>> fallback, const Range& range,
                             std::string_view unit, double factor = 1.0);

/// [m] of one unit of the key `length_unit`: m, cm, mm or in.
double read_length_unit(CaseTable& table);

}  // namespace tiprub::mesh
