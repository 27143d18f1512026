// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace tiprub {

/// A local maximum of a curve, and the valleys it stands between.
struct Peak {
  Eigen::Index index = 0;
  Eigen::Index left_valley = 0;   ///< lowest sample between the peak and the next higher one (or the end) on its left
  Eigen::Index right_valley = 0;  ///< the same on its right
  double prominence = 0;          ///< height above the higher of the two valleys
};

/// Of the parabola through a sample and its two neighbours: where it is highest.
struct ParabolaTop {
  double offset = 0;  ///< of the place, from the middle sample
  double height = 0;  ///< above the middle sample
};

/// Needs a middle sample that is higher than one neighbour and not lower than the other; places ascending.
ParabolaTop parabola_top(const std::array<double, 3>& places, const std::array<double, 3>& values);

/// Samples higher than both neighbours (of equal ones the first), whose prominence is at least `share` of their own
/// height. The two ends are no peaks: nobody knows what follows. Ascending in index.
std::vector<Peak> find_peaks(const Eigen::VectorXd& curve, double share);

/// The ends of a curve towards which it rises by at least `share` of its height there: a peak may lie beyond them.
std::vector<Eigen::Index> rising_ends(const Eigen::VectorXd& curve, double share);

}  // namespace tiprub
