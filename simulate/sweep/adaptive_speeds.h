// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "simulate/response/peaks.h"

namespace tiprub::simulate {

/// A response over speed, ascending, from scanned speeds or from fully computed ones. The two are never mixed: a scan
/// is off by some percent, and the steps between the two kinds would look like peaks.
using SampledCurve = std::vector<SampledSpeed>;

/// When a peak or a jump of a curve counts as located.
struct LocationGoal {
  PeakMeasure peaks;         ///< other maxima are ignored
  double speed = 1e-3;       ///< [1] half width of the interval around a peak
  double amplitude = 1e-2;   ///< [1] how far the curve may rise above a peak between its samples
  double narrowest = 1e-4;   ///< [1] of the speed: no gap beside a peak becomes narrower
  double fall = 0.02;        ///< [1] of the height of a peak: the response must be seen to fall by this much ...
  double flank = 5e-3;       ///< [1] ... within this share of the speed, so that no higher peak hides beside it
  double jump = 0.3;         ///< [1] change of amplitude between neighbours
  double jump_width = 1e-3;  ///< [1] of the speed: width of the interval around a jump
  double jump_reach = 6e-3;  ///< [1] of the speed: neighbours farther apart are not a jump

  /// The goal that resolves a peak of this damping ratio (see resolving_spacing).
  static LocationGoal of_damping(double ratio);
  /// The goal for a scan: wider intervals, a look farther down the sides of peaks, and all jumps.
  LocationGoal of_scan() const;
};

/// The given speeds, and at least `per_interval` even speeds between every two of them: so many that no resonance of
/// this damping ratio is missed (see finding_spacing), unless there would be more than `most` speeds in all.
std::vector<double> speeds_to_scan(const std::vector<double>& given, int per_interval, double damping_ratio,
                                   std::size_t most);

/// The speeds that a curve needs next to locate every peak and every jump: ascending and new; empty when all are
/// located. Near a peak this is the vertex of the parabola through its three samples. If the vertex is the peak
/// itself, a speed is added on each side whose gap is still too wide, and then in the middle of a gap in which the
/// curve may still rise. The interval of a jump is halved. When all this is done, a speed is added where the side
/// of a peak falls between two distant speeds.
std::vector<double> speeds_to_refine(const SampledCurve& curve, const LocationGoal& goal);

/// The speeds that must be computed in full to confirm the located peaks and jumps of a scan. For each peak these
/// are the vertex of the parabola, a speed on each side within the goal, and the valleys, unless a speed in `full`
/// shows that the response falls to half before them. For each jump they are both of its sides and a speed beyond
/// each. Speeds in `full`, and speeds beyond the ends of the scan, are left out.
std::vector<double> speeds_to_confirm(const SampledCurve& scan, const SampledCurve& full, const LocationGoal& goal);

/// The indices of the lower sides of the jumps of a curve, ascending.
std::vector<std::size_t> located_jumps(const SampledCurve& curve, const LocationGoal& goal);

/// The indices of the peaks of a curve, ascending.
std::vector<std::size_t> located_peaks(const SampledCurve& curve, const LocationGoal& goal);

}  // namespace tiprub::simulate
