// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/motion/rotor_state.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"

namespace tiprub {

struct SpeedResult {
  SpeedResponse response;
  RotorState end;  ///< after the recording; at rest if the speed failed
};

/// From a state to the settled motion at one speed [rad/s], its recording and its audit. From a state not at rest, it
/// is compared with the motion from rest.
/// A speed that fails (a clearance closed by spin, an unstable rotor, a step too long for its scheme, too few modes
/// for the contact nodes, a motion that grows without bound) comes back with its reason in `failure`; nothing is
/// raised.
SpeedResult simulate_speed(const Scene& scene, double speed, Depth depth = Depth::full, const RotorState& start = {});

}  // namespace tiprub
