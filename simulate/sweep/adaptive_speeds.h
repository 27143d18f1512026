// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tiprub {

/// A speed of a sweep and how large its motion is.
struct SampledSpeed {
  enum class Kind { scanned, full };

  double speed = 0;      ///< [rad/s]
  double amplitude = 0;  ///< [m]
  Kind kind = Kind::full;
};

/// When a peak or a jump of the response counts as located.
struct LocationGoal {
  double prominence = 0.1;  ///< [1] of a peak's height: lower ones aren't looked for
  double speed = 1e-3;      ///< [1] half width of the interval around a peak, width of that around a jump
  double amplitude = 1e-2;  ///< [1] what the parabola through a peak may add to it
  double narrowest = 1e-4;  ///< [1] distance of the parabola's vertex from a sample that it is left at
  double fall = 0.02;       ///< [1] of a peak's height: how far the response must be seen to fall on its sides
  double flank = 5e-3;      ///< [1] of the speed: within this much, so that no higher peak hides beside it
  double jump = 0.3;        ///< [1] change of amplitude between neighbours
};

/// The speeds that must be computed in full next, so that every peak and every jump becomes located: ascending, and
/// none of those that are there. None at all: done. From a peak's three samples the parabola's vertex is next, or,
/// where it is the peak itself, a speed on each side that is still too wide; a scanned peak, its scanned
/// valleys, and a scanned neighbour inside the goal, are computed themselves. Where a peak's side falls off between
/// two far speeds, the one between them is next. A jump's interval is halved. `curve`
/// ascending in speed.
std::vector<double> speeds_to_refine(const std::vector<SampledSpeed>& curve, const LocationGoal& goal);

/// The places in the curve of the peaks that are computed in full, ascending.
std::vector<std::size_t> located_peaks(const std::vector<SampledSpeed>& curve, const LocationGoal& goal);

}  // namespace tiprub
