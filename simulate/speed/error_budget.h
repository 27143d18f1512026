// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/program/helpers.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"
#include "simulate/speed/settled_march.h"

namespace tiprub::simulate {

/// The error budget of a critical speed [rad/s]: the place and the size of its peak if one thing that a designer does
/// not know exactly has another value. Varied are friction at the tips, the order of the gap, each ratio of
/// [simulate] budget_damping, the clearance (smaller and larger by budget_clearance), and the model of the wheel.
///
/// Each peak is followed from the critical speed with a coarse step (followed_peak.h), among motions with the same
/// largest engine order as `motion`. The half-width of the search is the smallest damping ratio, within 0.2 and 1 %,
/// times the speed; this assumes a frequency that does not depend on the speed. The new top is marched within the
/// tolerances, and its states are kept, so that its stress can be computed. If the response jumps beside the top, up
/// to three speeds farther from the jump are marched.
///
/// If `motion` repeats, the last row compares the vertices of parabolas through three speeds with the step of
/// `motion` and with half of it. Each row costs some five speeds. A row whose peak is not found has its `failure`
/// set; nothing is raised for it. `helpers` take a share of the rows; the result is the same.
std::vector<PeakVariation> error_budget(const Scene& scene, double speed, const SettledMotion& motion,
                                        Helpers* helpers = nullptr);

}  // namespace tiprub::simulate
