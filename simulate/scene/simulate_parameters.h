// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/motion/scene_choices.h"
#include "simulate/scene/damping.h"

namespace tiprub {

enum class DiameterChoice {
  symmetric,  ///< only those that the casing's orders can move from rest
  all,
};

/// Where the march of a speed starts.
enum class SweepDirection {
  rest,  ///< each speed from rest: speeds are independent
  up,    ///< from the motion at the next lower speed
  down,  ///< from the motion at the next higher speed
};

/// Which speeds a sweep has.
enum class SpeedChoice {
  given,     ///< those of the case
  adaptive,  ///< those, and what it takes to locate the peaks and the jumps of the response
};

/// What is done about the speeds at the response's peaks.
enum class Examination {
  none,
  critical_speeds,  ///< other starts, the step, the whole wheel where symmetry doesn't clearly hold; the cycle is
                    ///< kept
};

/// How a speed comes to its settled motion.
enum class SteadyStateMethod {
  march,  ///< by marching until it has settled
  orbit,  ///< by Newton's method for a fixed point of the symmetric map, from a short march; by marching if that
          ///< fails
};

/// Which orbits are followed over speed, once the sweep is done.
enum class BranchChoice {
  none,
  critical_speeds,  ///< those at the speeds that were examined
};

/// What is done about speeds whose symmetric motion is unstable.
enum class BrokenSymmetry {
  mark,      ///< they are named
  full_run,  ///< and run again with all nodal diameters, into a response of their own
};

/// What [simulate] asks for.
struct SimulateParameters {
  std::vector<double>
      speeds;  ///< [rad/s], ascending, all different: all, or those that an adaptive sweep begins with
  SpeedChoice speed_choice = SpeedChoice::given;
  int scan_per_interval = 0;     ///< scanned speeds between two of an adaptive sweep's first ones
  int speed_count_max = 0;       ///< of an adaptive sweep
  double peak_prominence = 0.1;  ///< [1] of a peak's height: lower ones are neither located nor examined
  Examination examination = Examination::none;
  Scheme scheme = Scheme::trigonometric;
  ContactRule contact = ContactRule::complementarity;
  double theta = 0.5;              ///< [1] of Moreau-Jean
  double penalty_stiffness = 100;  ///< [1] of penalty, in tip stiffnesses
  int modes = 0;                   ///< with mass, a nodal diameter; 0: all
  SweepDirection sweep = SweepDirection::rest;
  Damping damping;
  /// [Hz] modes and motions above it are the mesh's, not the wheel's; 0 in a case: what the model says
  double resolved_frequency = std::numeric_limits<double>::infinity();
  DiameterChoice nodal_diameters = DiameterChoice::symmetric;
  double damping_ratio_beyond = 0;  ///< [1] of critical, of modes above the resolved frequency
  double accuracy = 0.02;           ///< [1] of a critical speed's amplitude; the tolerances' defaults come from it
  double step_tolerance = 5e-3;     ///< [1] of the settled motion: the step is halved until that changes it by less
  double steps_per_period = 200;    ///< at least, of the lowest natural frequency, of the first march
  int steps_per_revolution = 0;     ///< at least, and never halved; 0: from steps_per_period
  int samples_per_revolution = 0;   ///< at least
  int recorded_revolutions = 0;
  int min_revolutions = 0;
  int max_revolutions = 0;
  SteadyStateMethod steady_state = SteadyStateMethod::march;
  double settle_tolerance = 0;  ///< [1] estimated distance from the settled motion, of its norm
  int casing_areas = 0;
  int symmetry_check_revolutions = 0;  ///< after settling, with a small disturbance of what symmetry left out
  BrokenSymmetry when_symmetry_breaks = BrokenSymmetry::mark;
  BranchChoice branches = BranchChoice::none;
  double branch_range = 0;  ///< [1] of a speed, to either side of it
  int branch_steps = 0;     ///< orbits to either side, at most
  int threads = 0;          ///< 0: as many as the machine has
};

/// Reads [simulate]. Raises InputError.
SimulateParameters read_simulate_parameters(CaseTable& table);

/// The resolved frequency as the model has it, if the case doesn't say, and the damping beyond it.
void fit_to_model(SimulateParameters& parameters, const ReducedModel& model);

}  // namespace tiprub
