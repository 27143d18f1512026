// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/program/helpers.h"
#include "simulate/motion/motion.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"

namespace tiprub::simulate {

struct SpeedResult {
  SpeedResponse response;
  RotorState end;  ///< after the recording; at rest if the speed failed
};

/// Computes one speed [rad/s] from a state: the settled motion, its recording and its checks. The motion from a state
/// not at rest is compared with the one from rest. If the speed fails (a clearance closed by spin, an unstable rotor,
/// a step too long for its scheme, too few modes for the contact nodes, a motion that grows without bound), `failure`
/// gives the reason; nothing is raised. `helpers` may take a share of an examination; the result is the same.
SpeedResult simulate_speed(const Scene& scene, double speed, Depth depth = Depth::full, const RotorState& start = {},
                           Helpers* helpers = nullptr);

}  // namespace tiprub::simulate
