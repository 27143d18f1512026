// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/march/rotor_at_speed.h"
#include "simulate/response/response.h"
#include "simulate/response/rotor_state.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// What else a critical speed may show: the motion that it comes to from those 1 % below ("up") and above ("down"),
/// from its own with twice the displacement ("disturbed"), and, where symmetry does not clearly hold, with all nodal
/// diameters from rest ("whole wheel"). All with the step of `response`, whose motion they are compared with, and
/// from which `end` is the state. With a step that was given, half of it is tried as well. Costs four to six marches.
/// Fills in `response.other_starts` and its audit.
void examine(const Scene& scene, const RotorAtSpeed& rotor, const RotorState& end, SpeedResponse& response);

}  // namespace tiprub
