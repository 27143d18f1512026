// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/motion/scene_choices.h"
#include "simulate/scene/damping.h"

namespace tiprub::simulate {

enum class DiameterChoice {
  symmetric,  ///< only those that the orders of the casing excite from rest
  all,
};

/// Where the march of a speed starts.
enum class SweepDirection {
  rest,  ///< each speed from rest: speeds are independent
  up,    ///< from the motion at the next lower speed
  down,  ///< from the motion at the next higher speed
};

/// The speeds of a sweep.
enum class SpeedChoice {
  given,     ///< those of the case
  adaptive,  ///< those, and the speeds needed to locate the peaks and jumps of the response
};

/// What is done at the peaks of the response.
enum class Examination {
  none,
  critical_speeds,  ///< other starts, half the step, the whole wheel where symmetry does not clearly hold; the
                    ///< cycle is kept
};

/// Who decides on the terms of the contact that a case leaves open: friction, and the second order of the gap.
enum class PhysicsChoice {
  as_given,   ///< the defaults of their keys
  as_needed,  ///< they are marched if they move a critical speed or its stress by more than `accuracy`
};

/// Which speeds get an error budget.
enum class BudgetChoice {
  none,
  largest,  ///< the critical speed with the largest amplitude
  critical_speeds,
};

/// How the settled motion of a speed is found.
enum class SteadyStateMethod {
  march,  ///< by marching until it has settled
  orbit,  ///< by Newton's method for a fixed point of the symmetric map after a short march; by marching if that
          ///< fails
};

/// Which orbits are followed over speed after the sweep.
enum class BranchChoice {
  none,
  critical_speeds,  ///< those at the examined speeds and at both sides of each jump
  speeds,           ///< and those at all other speeds with a periodic motion
};

/// What is done about speeds whose symmetric motion is unstable.
enum class BrokenSymmetry {
  mark,      ///< they are reported
  full_run,  ///< they are also computed with all nodal diameters, and written to a second response
};

/// The parameters of [simulate].
struct SimulateParameters {
  std::vector<double>
      speeds;  ///< [rad/s] ascending, all different: all speeds, or the first ones of an adaptive sweep
  SpeedChoice speed_choice = SpeedChoice::given;
  int scan_per_interval = 0;     ///< of an adaptive sweep: least number between two given speeds
  int speed_count_max = 0;       ///< of an adaptive sweep
  double peak_prominence = 0.1;  ///< [1] of a peak's height; peaks with less are neither located nor examined
  Examination examination = Examination::none;
  BudgetChoice budget = BudgetChoice::none;
  double budget_friction = 0;          ///< [1] coefficient
  std::vector<double> budget_damping;  ///< [1] of critical
  double budget_clearance = 0;         ///< [m] tolerance
  Scheme scheme = Scheme::trigonometric;
  ContactRule contact = ContactRule::complementarity;
  GapOrder gap = GapOrder::automatic;
  double theta = 0.5;              ///< [1] of Moreau-Jean
  double penalty_stiffness = 100;  ///< [1] of penalty, in tip stiffnesses
  int modes = 0;                   ///< modes with mass in a nodal diameter; 0: all
  SweepDirection sweep = SweepDirection::rest;
  Damping damping;
  /// [Hz] Modes and motions above it are artefacts of the mesh. 0 in a case: resolved_frequency(model).
  double resolved_frequency = std::numeric_limits<double>::infinity();
  DiameterChoice nodal_diameters = DiameterChoice::symmetric;
  double damping_ratio_beyond = 0;  ///< [1] of critical, of modes above the resolved frequency
  double accuracy = 0.02;           ///< [1] of the amplitude of a critical speed; sets the defaults of the tolerances
  double step_tolerance = 5e-3;     ///< [1] of the settled motion: the step is halved until the change is smaller
  double steps_per_period = 200;    ///< least number per period of the lowest natural frequency, in the first march
  int steps_per_revolution = 0;     ///< least number, never halved; 0: steps_per_period applies
  int samples_per_revolution = 0;   ///< least number
  int samples_per_lobe = 1;         ///< least number
  int recorded_revolutions = 0;
  int min_revolutions = 0;
  int max_revolutions = 0;
  SteadyStateMethod steady_state = SteadyStateMethod::march;
  double settle_tolerance = 0;  ///< [1] estimated distance from the settled motion
  int casing_areas = 0;
  int symmetry_check_revolutions = 0;  ///< marched for the growth of what symmetry leaves out
  BrokenSymmetry when_symmetry_breaks = BrokenSymmetry::mark;
  BranchChoice branches = BranchChoice::none;
  double branch_range = 0;  ///< [1] of a speed, to either side of it
  int branch_steps = 0;     ///< largest number of orbits to either side
  bool unusual = false;     ///< values that are usual for no wheel are meant
  int threads = 0;          ///< 0: as many as the machine has
  PhysicsChoice physics = PhysicsChoice::as_given;
  std::string budget_model;  ///< file of another model of the wheel, beside the case, for error budgets; empty: none
};

/// Reads [simulate]. Raises InputError.
SimulateParameters read_simulate_parameters(CaseTable& table);

/// Refuses speeds that are probably in rad/s or Hz, and a resolved frequency that is probably in kHz. Raises
/// InputError at the key.
void require_units_of_model(const CaseTable& table, const SimulateParameters& parameters, const ReducedModel& model);

/// Refuses a gap of second order where the model does not hold it. Raises InputError at the key.
void require_gap_of_model(const CaseTable& table, const SimulateParameters& parameters, const ReducedModel& model);

/// Sets the resolved frequency and the order of the gap from the model, unless the case gives them, and the damping
/// beyond that frequency.
void fit_to_model(SimulateParameters& parameters, const ReducedModel& model);

}  // namespace tiprub::simulate
