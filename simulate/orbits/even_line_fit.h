// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tiprub {

/// A line through values at even distances.
struct EvenLine {
  double slope = 0;        ///< per place; 0 of fewer than two values
  double uncertainty = 0;  ///< standard error of the slope; 0 of fewer than three
};

/// Least squares. Two sums: the mean of the places is known, where Boost's simple_ordinary_least_squares wants the
/// places in a container of their own and updates running means, which costs digits.
EvenLine fit_even_line(const std::vector<double>& values);

}  // namespace tiprub
