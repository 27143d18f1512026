// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/response/response.h"
#include "simulate/response/rotor_state.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// What is looked at beside the march itself.
enum class StepCheck { none, halved };

struct SpeedResult {
  SpeedResponse response;
  RotorState end;  ///< after the recording; at rest if the speed failed
};

/// From a state to the settled motion at one speed [rad/s], its recording and its audit. With `halved` the speed is
/// computed with half the step as well (twice the cost again); from a state not at rest, also from rest. A speed that
/// fails (a clearance closed by spin, an unstable rotor, a step too long for its scheme, too few modes for the
/// contact nodes, a motion that grows without bound) comes back with its reason in `failure`; nothing is raised.
SpeedResult simulate_speed(const Scene& scene, double speed, StepCheck check = StepCheck::none,
                           const RotorState& start = {});

}  // namespace tiprub
