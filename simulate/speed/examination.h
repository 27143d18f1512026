// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simulate/motion/attempt.h"
#include "simulate/motion/rotor_state.h"
#include "simulate/orbits/speed_audit.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"
#include "simulate/speed/settled_march.h"

namespace tiprub {

/// What else a critical speed may show: the motion that it comes to from those 1 % below ("up") and above ("down"),
/// from its own with twice the displacement ("disturbed"), and, where symmetry does not clearly hold, with all nodal
/// diameters from rest ("whole wheel"). All with the step of `found`, whose motion they are compared with, and from
/// which `end` is the state. Costs three or four marches.
std::vector<OtherStart> other_starts(const Scene& scene, const SharedRotor& rotor, const RotorState& end,
                                     const SettledMotion& found, SymmetryVerdict symmetry);

/// What half the step changes, starting from `end`, of a motion whose step was given.
Attempt<MotionDifference> halved_step(const Scene& scene, const SharedRotor& rotor, const RotorState& end,
                                      const SettledMotion& found);

}  // namespace tiprub
