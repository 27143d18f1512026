// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simulate/response/response.h"
#include "simulate/scene/scene.h"
#include "simulate/speed/settled_march.h"

namespace tiprub::simulate {

/// Where the peak of a critical speed [rad/s] stands, and how large its motion is, if one thing that a designer does
/// not know exactly has another value: friction at the tips, the order of the gap, each ratio of [simulate]
/// budget_damping, a clearance smaller and larger by budget_clearance, and another model of the wheel. Each peak is
/// followed with a coarse step from the critical speed (followed_peak.h), among motions whose largest engine order is
/// that of `motion`; the new top is then marched within the tolerances, and its states are kept, so that its stress
/// can be computed. The last row has half the step of `motion`, if that repeats. Costs some five speeds a row.
std::vector<PeakVariation> error_budget(const Scene& scene, double speed, const SettledMotion& motion);

}  // namespace tiprub::simulate
