// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "simulate/response/peaks.h"

namespace tiprub::simulate {

/// The peak that is followed, as it is before something about the wheel or the casing changes.
struct PeakOrigin {
  double speed = 0;       ///< [rad/s] of its top
  double half_width = 0;  ///< [rad/s] of the narrowest resonance there
};

/// Whether the response jumps beside a top: a neighbour has less than 80 % of its amplitude.
bool jumps(const PeakTop& peak);

/// The amplitude [m] at a speed [rad/s]: negative where the motion belongs to another peak, empty where there is no
/// motion.
using AmplitudeAt = std::function<std::optional<double>(double speed)>;

/// Finds the new place of a peak. The response is sampled within four half-widths around the old top, and in steps of
/// two half-widths beyond an end towards which it rises, or which still has half of the largest amplitude, up to a
/// tenth of the speed: a change may move a peak beyond a smaller one, or split it. The highest maximum, and those of
/// more than half of its amplitude, are sampled at every half-width; the highest of them is the peak. Its top is
/// located until the intervals on both sides are at most a fifth of a half-width. It is no top if the response goes
/// on there as that of another peak. Raises NoMotion if there is no maximum.
PeakTop follow_peak(const PeakOrigin& origin, const AmplitudeAt& amplitude_at);

}  // namespace tiprub::simulate
