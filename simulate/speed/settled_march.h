// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "simulate/march/rotor_at_speed.h"
#include "simulate/march/time_march.h"
#include "simulate/periodic/orbit_search.h"
#include "simulate/response/response.h"
#include "simulate/response/rotor_state.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// Whether the whole rotor's states are kept at every recorded sample: of a settled motion's period, or of two
/// revolutions.
enum class CycleChoice { left, kept };

/// How one march of a speed is to be done.
struct MarchPlan {
  int steps_per_revolution = 0;
  int min_revolutions = 0;  ///< before settling is judged
  CycleChoice cycle = CycleChoice::left;
  OrbitSearch* search = nullptr;  ///< jumps to the settled motion, if it may
};

/// The rotor of a scene at a speed [rad/s]. Raises RunError if it is unstable there.
RotorAtSpeed rotor_of(const Scene& scene, double speed, OtherDiameters others = OtherDiameters::known);

/// [m] what is left of the clearance at a speed in rad/s, at the contact nodes. Raises RunError if spin closes it.
Eigen::VectorXd open_clearance(const Scene& scene, double speed);

/// From a state to the settled motion with one step: the march at its end; its recording and all that is known of it
/// in `response`, whose speed is given. `response.revolutions` counts on.
/// Raises RunError with the reason of a failure: a clearance that spin closes, a step too long for its scheme, too
/// few modes for the contact nodes, a motion that grows without bound.
std::unique_ptr<TimeMarch> settle(const Scene& scene, const RotorAtSpeed& rotor, const RotorState& start,
                                  const MarchPlan& plan, SpeedResponse& response);

/// The same with a step that is halved, each time going on from where the last march ended, until a halving changes
/// the settled motion by no more than step_tolerance; the last halving's difference stands in `response.audit`. A
/// halving that makes nothing better, or a motion that doesn't settle, ends it too: the difference says what was
/// reached. With [simulate] steps_per_revolution: that step, whatever its error.
std::unique_ptr<TimeMarch> settle_within_tolerance(const Scene& scene, const RotorAtSpeed& rotor,
                                                   const RotorState& start, CycleChoice cycle,
                                                   SpeedResponse& response);

/// From rest with a coarse step to an amplitude within a few percent, at a quarter of the cost or less: for where to
/// look, and for a state to start from.
std::unique_ptr<TimeMarch> settle_roughly(const Scene& scene, const RotorAtSpeed& rotor, SpeedResponse& response);

}  // namespace tiprub
