// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "cases/program/text_file.h"

namespace tiprub::simulate {

/// A smooth periodic function through given points. It consists of monotone cubics (Fritsch and Butland 1984, Boost's
/// pchip), never leaves the range of neighbouring points, and has a continuous first derivative. One point gives a
/// constant.
class PeriodicTable {
 public:
  PeriodicTable() = default;
  /// [1] of the period: the smallest distance of two points. Rounding could merge closer points one period later.
  static constexpr double closest = 1e-9;
  /// Points [x, y] with x increasing by more than `closest` inside [x_0, x_0 + period).
  PeriodicTable(const std::vector<std::array<double, 2>>& points, double period);

  double operator()(double x) const;

 private:
  std::function<double(double)> cubic_;  ///< over start_ .. start_ + period_
  double start_ = 0.0;
  double period_ = 1.0;
};

/// A measured distortion of the casing over angle and chord: monotone cubic over the angle (PeriodicTable), linear
/// over the chord between two stations, and constant beyond the first and the last station.
class CasingProfile {
 public:
  CasingProfile() = default;
  /// `stations` are fractions of the arc length, ascending in 0 .. 1; `columns` hold the points [rad, m inward] of
  /// each station, whose angles ascend inside one period.
  CasingProfile(std::vector<double> stations, const std::vector<std::vector<std::array<double, 2>>>& columns,
                double period);

  /// [m] inward, at an angle [rad] and a fraction of the arc length.
  double operator()(double angle, double fraction) const;
  /// [m] The largest absolute value of all points.
  double largest() const { return largest_; }

 private:
  std::vector<double> stations_;
  std::vector<PeriodicTable> curves_;  ///< one for each station
  double largest_ = 0;
};

/// Reads a table of numbers. The first line holds a word and the stations. Each further line holds an angle [deg],
/// ascending in 0 .. period with that end excluded, and the distortion inward [m] at each station. Raises InputError
/// with the line.
CasingProfile read_casing_profile(const NamedText& file, double period);

}  // namespace tiprub::simulate
