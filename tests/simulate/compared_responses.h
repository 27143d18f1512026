// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/orbits/speed_audit.h"
#include "simulate/response/response.h"

namespace tiprub::simulate::testing {

/// How far the motions of two responses of one speed are apart.
inline MotionDifference difference(const SpeedResponse& here, const SpeedResponse& there, int lobes) {
  const auto sampled = [](const SpeedResponse& at) {
    return SampledMotion{at.displacement, at.samples_per_revolution, at.recorded_revolutions, at.period_revolutions};
  };
  return tiprub::simulate::difference(sampled(here), sampled(there), lobes);
}

}  // namespace tiprub::simulate::testing
