// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace tiprub {

/// A speed of a sweep and the amplitude of its motion.
struct SampledSpeed {
  double speed = 0;      ///< [rad/s]
  double amplitude = 0;  ///< [m]
};

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

/// The highest sample of a peak and its two neighbours.
struct PeakTop {
  SampledSpeed left, top, right;

  double left_gap() const { return top.speed - left.speed; }    ///< [rad/s]
  double right_gap() const { return right.speed - top.speed; }  ///< [rad/s]
  double vertex() const;                                        ///< [rad/s] of the parabola through the three samples
};

/// The samples that are higher than both neighbours (the first of equal ones) and whose prominence is at least
/// `share` of their height; ascending in index. The two ends are never peaks, because the curve may rise beyond them.
std::vector<Peak> find_peaks(const Eigen::VectorXd& curve, double share);

// Distances of speeds in half-widths of a resonance over speed. A half-width is the damping ratio times the speed.
inline constexpr double finding_spacing = 2;      ///< the sample next to a top still has 0.7 of its height
inline constexpr double resolving_spacing = 0.5;  ///< a top is at most 3 % higher than the samples beside it

/// Decides which maxima of a response are named as peaks.
struct PeakMeasure {
  double prominence = 0.1;  ///< [1] of a peak's height
  double severe = 0.8;      ///< [1] of the curve's largest value: a maximum that reaches it needs only `apart`
  double apart = 0.02;      ///< [1] of a peak's height: a maximum of less prominence is part of another, ragged peak
};

/// As find_peaks(), and also the maxima that are nearly as high as the largest one, even if the valley beside them
/// is shallow.
std::vector<Peak> named_peaks(const Eigen::VectorXd& curve, const PeakMeasure& measure);

/// How far a curve may rise above its peak at sample `place` before the next sample in direction `step`. The
/// flanks of a top bend inwards, so that the curve stays below the line through the two samples before and below
/// the line through the two samples that follow. After a jump the second line passes below the peak; then the
/// curve is assumed to rise by at most as much as it falls to the next sample.
double rise_beside(const Eigen::VectorXd& places, const Eigen::VectorXd& curve, Eigen::Index place, int step);

/// The ends of a curve towards which it rises by at least `share` of its height there: a peak may lie beyond them.
std::vector<Eigen::Index> rising_ends(const Eigen::VectorXd& curve, double share);

}  // namespace tiprub
