// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "simulate/response/peaks.h"

namespace tiprub::simulate {

/// The peak that is followed, before something about the wheel or the casing changes.
struct PeakOrigin {
  double speed = 0;       ///< [rad/s] of its top
  double half_width = 0;  ///< [rad/s] of the narrowest resonance there
};

/// The top of a sampled curve and its neighbours.
struct PeakTop {
  SampledSpeed left, top, right;

  double left_gap() const { return top.speed - left.speed; }
  double right_gap() const { return right.speed - top.speed; }
  /// The motion at the top is another one than beside it.
  bool jumps() const;
  /// [rad/s] The vertex of the parabola through the three.
  double vertex() const;
};

/// [m] over [rad/s]; zero where the motion is that of another peak, empty where there is none.
using AmplitudeAt = std::function<std::optional<double>(double speed)>;

/// Finds where a peak has gone. The response is sampled around the old top, and beyond an end towards which it rises,
/// up to a tenth of the speed, because a change may move a peak so far that it lies beside a smaller one. The highest
/// maximum found is the peak. Its top is then located to a fifth of a half-width. Raises NoMotion if there is none.
PeakTop follow_peak(const PeakOrigin& origin, const AmplitudeAt& amplitude_at);

}  // namespace tiprub::simulate
