// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace tiprub {

/// A speed of a sweep and how large its motion is.
struct SampledSpeed {
  double speed = 0;      ///< [rad/s]
  double amplitude = 0;  ///< [m]
};

/// A response over speed, ascending: as it was scanned, or as it was computed in full, never mixed. A scan is off by
/// percents, and the steps from one to the other would be taken for peaks.
using SampledCurve = std::vector<SampledSpeed>;

/// When a peak or a jump of a curve counts as located.
struct LocationGoal {
  double prominence = 0.1;   ///< [1] of a peak's height: lower ones aren't looked for
  double speed = 1e-3;       ///< [1] half width of the interval around a peak
  double amplitude = 1e-2;   ///< [1] what the parabola through a peak may add to it
  double narrowest = 1e-4;   ///< [1] distance of the parabola's vertex from a sample that it is left at
  double fall = 0.02;        ///< [1] of a peak's height: how far the response must be seen to fall on its sides
  double flank = 5e-3;       ///< [1] of the speed: within this much, so that no higher peak hides beside it
  double jump = 0.3;         ///< [1] change of amplitude between neighbours
  double jump_width = 1e-3;  ///< [1] of the speed: width of the interval around a jump
  double jump_reach = 6e-3;  ///< [1] of the speed: neighbours farther apart may differ without a jump

  /// The same, as far as a scan can tell: wider, with a look farther down the sides of peaks, and at all jumps.
  LocationGoal of_scan() const;
};

/// The speeds that a curve needs next, so that every peak and every jump becomes located: ascending, and none that it
/// has. None at all: done. From a peak's three samples the parabola's vertex is next, or, where it is the peak
/// itself, a speed on each side that is still too wide. A jump's interval is halved. Last, where a peak's side falls
/// off between two far speeds, the one between them is next.
std::vector<double> speeds_to_refine(const SampledCurve& curve, const LocationGoal& goal);

/// Of a scan whose peaks and jumps are located: the speeds that must be computed in full to confirm them. For each
/// peak the parabola's vertex and a speed on each side within the goal, and its valleys, unless a speed in `full`
/// shows that the response falls to half between; for each jump both of its sides, and one beyond each. None that
/// `full` has, and none beyond the scan's ends.
std::vector<double> speeds_to_confirm(const SampledCurve& scan, const SampledCurve& full, const LocationGoal& goal);

/// The places in the curve of its peaks, ascending.
std::vector<std::size_t> located_peaks(const SampledCurve& curve, const LocationGoal& goal);

}  // namespace tiprub
