// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tiprub {

/// Slope, per place, of the least-squares line through values at even distances; 0 of fewer than two. Two sums: the
/// mean of the places is known, where Boost's simple_ordinary_least_squares wants the places in a container of their
/// own and updates running means, which costs digits.
double slope_per_place(const std::vector<double>& values);

}  // namespace tiprub
