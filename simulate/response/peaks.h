// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace tiprub {

/// A local maximum of a curve, and the valleys on both sides of it.
struct Peak {
  Eigen::Index index = 0;
  Eigen::Index left_valley = 0;   ///< lowest sample between the peak and the next higher one (or the end) on the left
  Eigen::Index right_valley = 0;  ///< the same on the right
  double prominence = 0;          ///< height above the higher of the two valleys
};

/// The vertex of the parabola through a sample and its two neighbours.
struct ParabolaTop {
  double offset = 0;  ///< from the middle sample
  double height = 0;  ///< above the middle sample
};

/// The middle sample must be higher than one neighbour and not lower than the other; places must ascend.
ParabolaTop parabola_top(const std::array<double, 3>& places, const std::array<double, 3>& values);

/// The samples that are higher than both neighbours (the first of equal ones) and whose prominence is at least
/// `share` of their height; ascending in index. The two ends are never peaks, because the curve may rise beyond them.
std::vector<Peak> find_peaks(const Eigen::VectorXd& curve, double share);

/// The ends of a curve towards which it rises by at least `share` of its height there: a peak may lie beyond them.
std::vector<Eigen::Index> rising_ends(const Eigen::VectorXd& curve, double share);

}  // namespace tiprub
