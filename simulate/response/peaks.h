// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace tiprub {

/// A local maximum of a curve, and the valleys it stands between.
struct Peak {
  Eigen::Index index = 0;
  Eigen::Index left_valley = 0;   ///< lowest sample between the peak and the next higher one (or the end) on its left
  Eigen::Index right_valley = 0;  ///< the same on its right
  double prominence = 0;          ///< height above the higher of the two valleys
};

/// Samples higher than both neighbours (of equal ones the first), whose prominence is at least `share` of their own
/// height. The two ends are no peaks: nobody knows what follows. Ascending in index.
std::vector<Peak> find_peaks(const Eigen::VectorXd& curve, double share);

/// The ends of a curve towards which it rises by at least `share` of its height there: a peak may lie beyond them.
std::vector<Eigen::Index> rising_ends(const Eigen::VectorXd& curve, double share);

}  // namespace tiprub
