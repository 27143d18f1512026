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

/// The other motions of a critical speed: from the motions 1 % below ("up") and 1 % above ("down"), from its own
/// motion with twice the displacement ("disturbed"), and, where symmetry does not clearly hold, from rest with all
/// nodal diameters ("whole wheel"). Each is marched with the step of `found` and compared with its motion; `end` is
/// the last state of `found`. Costs three or four marches.
std::vector<OtherStart> other_starts(const Scene& scene, const SharedRotor& rotor, const RotorState& end,
                                     const SettledMotion& found, SymmetryVerdict symmetry);

/// The change of a motion by half its step, starting from `end`; for motions whose step the case fixes.
Attempt<MotionDifference> halved_step(const Scene& scene, const SharedRotor& rotor, const RotorState& end,
                                      const SettledMotion& found);

}  // namespace tiprub
