// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "simulate/march/time_march.h"
#include "simulate/motion/rotor_state.h"
#include "simulate/orbits/recording.h"
#include "simulate/orbits/settling.h"
#include "simulate/orbits/speed_audit.h"
#include "simulate/periodic/orbit_search.h"
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

/// A march that has come to its settled motion, or as near as it was allowed to, and what was recorded there.
struct SettledMotion {
  std::unique_ptr<TimeMarch> march;  ///< at the end of the recording
  Recorded recorded;
  MotionReading reading;
  SettlingState state;
  int revolutions = 0;              ///< marched in all, the recorded ones included
  double step_ratio = 0;            ///< [1] h omega_max / 2
  double compliance_condition = 0;  ///< [1] of W

  /// Refers to this motion.
  SampledMotion sampled() const {
    return {recorded.displacement, recorded.samples_per_revolution, recorded.revolutions, state.period_revolutions};
  }
};

/// From a state to the settled motion with one step.
/// Raises NoMotion with the reason of a failure: a clearance that spin closes, a step too long for its scheme, too
/// few modes for the contact nodes, a motion that grows without bound.
SettledMotion settle(const Scene& scene, const SharedRotor& rotor, const RotorState& start, const MarchPlan& plan);

/// A settled motion, how exact its step is, and how it was found.
struct RefinedMotion {
  SettledMotion motion;
  std::optional<MotionDifference> halving;  ///< what the last halving of the step changed
  OrbitReport orbit;
  std::optional<Growth> excluded;  ///< of what symmetry leaves out, along an orbit that was found
};

/// The same with a step that is halved, each time going on from where the last march ended, until a halving changes
/// the settled motion by no more than step_tolerance. A halving that makes nothing better, or a motion that doesn't
/// settle, ends it too: the difference says what was reached. With [simulate] steps_per_revolution: that step,
/// whatever its error.
RefinedMotion settle_within_tolerance(const Scene& scene, const SharedRotor& rotor, const RotorState& start,
                                      CycleChoice cycle);

/// From rest with a coarse step to an amplitude within a few percent, at a quarter of the cost or less: for where to
/// look, and for a state to start from.
SettledMotion settle_roughly(const Scene& scene, const SharedRotor& rotor);

}  // namespace tiprub
