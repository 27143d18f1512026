// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"
#include "simulate/orbits/recording.h"
#include "simulate/orbits/settling.h"
#include "simulate/orbits/speed_audit.h"
#include "simulate/periodic/orbit_search.h"
#include "simulate/scene/scene.h"

namespace tiprub::simulate {

/// Whether the states of the whole rotor are kept at every sample of the period, or of two revolutions of a motion
/// that does not settle.
enum class CycleChoice { left, kept };

/// The settings of one march.
struct MarchPlan {
  int steps_per_revolution = 0;
  int min_revolutions = 0;  ///< marched before settling is judged
  CycleChoice cycle = CycleChoice::left;
  OrbitSearch* search = nullptr;  ///< puts the march onto the settled motion, if given
  StartMotion start = StartMotion::unknown;
};

/// A march at its settled motion, or as near to it as the allowed revolutions lead, and the recording of that motion.
struct SettledMotion {
  std::unique_ptr<TimeMarch> march;  ///< at the end of the recording
  RecordedMotion recorded;
  MotionReading reading;
  SettlingState state;
  int revolutions = 0;              ///< in all, the recorded ones included
  double step_ratio = 0;            ///< [1] h omega_max / 2
  double compliance_condition = 0;  ///< [1] of W

  /// For difference(); refers to this motion.
  SampledMotion sampled() const {
    return {recorded.displacement, recorded.samples_per_revolution, recorded.recorded_revolutions,
            state.period_revolutions};
  }
};

/// Marches from a state to the settled motion with one step size. Raises NoMotion with the reason of a failure: a
/// clearance closed by spin, a step too long for its scheme, too few modes for the contact nodes, or a motion that
/// grows without bound.
SettledMotion settle(const Scene& scene, const SharedRotor& rotor, const RotorState& start, const MarchPlan& plan);

/// A settled motion, how exact its step is, and how it was found.
struct RefinedMotion {
  SettledMotion motion;
  std::optional<MotionDifference> halving;  ///< change of the motion by the last halving of the step
  std::optional<double> step_reached;       ///< [1] estimated error of the step over step_tolerance
  OrbitReport orbit;
  std::optional<Growth> excluded;  ///< growth of what symmetry leaves out, if an orbit was found
};

/// The same, but halves the step until the settled motion changes by no more than step_tolerance; each march
/// continues from the end of the last one, and the first one, if from rest, takes steps twice as long. Halving also
/// ends if it brings no improvement or if the motion does not settle: the difference then tells the accuracy reached.
/// With [simulate] steps_per_revolution, marches with that step only.
RefinedMotion settle_within_tolerance(const Scene& scene, const SharedRotor& rotor, const RotorState& start,
                                      CycleChoice cycle);

/// Marches from rest with a coarse step. The amplitude is right within a few percent, at a quarter of the cost or
/// less: for scans, and for states to start from.
SettledMotion settle_roughly(const Scene& scene, const SharedRotor& rotor);

}  // namespace tiprub::simulate
