// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/program/text_file.h"
#include "simulate/scene/periodic_table.h"

namespace tiprub {

/// A casing's distortion over angle and chord, as it was measured: monotone cubic over the angle (PeriodicTable),
/// linear over the chord between two stations, level outside of the first and the last.
class CasingProfile {
 public:
  CasingProfile() = default;
  /// stations: ascending fractions of the arc length, 0 .. 1. Angles [rad]: ascending inside one period. inward:
  /// [m], a row for each angle, of one number for each station.
  CasingProfile(std::vector<double> stations, const std::vector<double>& angles,
                const std::vector<std::vector<double>>& inward, double period);

  /// [m] inward, at an angle [rad] and a fraction of the arc length.
  double operator()(double angle, double fraction) const;
  /// [m] the largest absolute value of all points.
  double largest() const { return largest_; }

 private:
  std::vector<double> stations_;
  std::vector<PeriodicTable> curves_;  ///< one for each station
  double largest_ = 0;
};

/// Reads a table of numbers: a first line with a word and the stations, and below it a line for each angle [deg],
/// ascending in 0 .. period, that end excluded, with what the casing stands inward [m] at each station. Raises
/// InputError with the line.
CasingProfile read_casing_profile(const NamedText& file, double period);

}  // namespace tiprub
