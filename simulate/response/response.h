// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reduce/model/modelled_effects.h"
#include "simulate/motion/motion.h"
#include "simulate/motion/rotor_state.h"
#include "simulate/motion/scene_choices.h"

namespace tiprub {

/// "periodic", "not settled", ...: as response.h5 has it.
const char* name_of(MotionClass motion);
/// "motion" or "spectrum": likewise.
const char* name_of(MotionMeasure measure);

/// How far a speed's result can be trusted: what was checked, beyond the ledger and the settling.
struct SpeedAudit {
  /// [1] relative difference to the same speed with half the step; only at a few speeds of a sweep
  std::optional<double> halving_difference;
  std::optional<MotionMeasure> halving_measure;  ///< of that difference
  std::string halving_failure;                   ///< empty, or why half the step gave no motion
  /// [1] factor per revolution of a small disturbance of the nodal diameters left out for symmetry
  std::optional<double> excluded_growth;
  std::optional<double> excluded_growth_uncertainty;  ///< [1] of that factor
  SymmetryVerdict symmetry = SymmetryVerdict::all_held;
  /// [1] relative difference to the same speed from rest, for a sweep that carries its state along
  std::optional<double> rest_difference;
  OrbitReport orbit;
  double left_out_energy = 0;       ///< [1] elastic energy of the modes without mass or dropped, of all of it
  double compliance_condition = 0;  ///< [1] condition number of W
  std::int64_t leftover_steps = 0;  ///< recorded steps that leave a node clearly in the casing
  double tension_share = 0;         ///< [1] share of tensile contact force: of the sum of the forces' magnitudes
};

/// From where a critical speed is looked at once more.
enum class Start {
  up,           ///< from the motion at the speed 1 % below
  down,         ///< from the motion at the speed 1 % above
  disturbed,    ///< from its own motion with twice the displacement
  whole_wheel,  ///< from rest with all nodal diameters, where symmetry does not clearly hold
};

/// "up", "down", "disturbed", "whole wheel": as response.h5 has it.
const char* name_of(Start start);

/// What a critical speed comes to from another start.
struct OtherStart {
  Start start = Start::up;
  std::string failure;   ///< empty, or why there is no motion; then the rest is
  double amplitude = 0;  ///< [m] as SpeedResponse has it
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;
  double difference = 0;  ///< [1] relative, to the motion of the speed's own start
};

/// How closely a speed was looked at.
enum class Depth {
  scanned,   ///< with a coarse step, for its amplitude alone; not in a finished response
  full,      ///< within the tolerances
  examined,  ///< from other starts as well, with the whole cycle kept
};

/// The settled response at one speed. A sample is an instant on whole revolutions: sample s of the recorded ones lies
/// at the rotor angle 2 pi s / samples_per_revolution. Only the `independent_sectors` = N / g first sectors are held,
/// g = gcd(N, orders of the casing): sector j moves as sector j mod (N / g) at every instant.
struct SpeedResponse {
  double speed = 0;     ///< [rad/s]
  std::string failure;  ///< empty, or why this speed has no response; then the arrays are empty
  int steps_per_revolution = 0;
  int samples_per_revolution = 0;
  int recorded_revolutions = 0;  ///< as many as asked for; of a settled motion one period, if that is less
  int revolutions = 0;           ///< marched in all, the recorded ones included
  Depth depth = Depth::full;
  double amplitude = 0;  ///< [m] half of the peak-to-peak normal displacement, the largest of nodes and sectors
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;        ///< of a periodic (1) or subharmonic motion, else 0
  int period_revolutions = 0;  ///< whole ones after which a settled motion repeats itself; 0 if it has not settled
  double off_beat_energy = 0;  ///< [1] share of the band's mean square at no multiple of lobes x Omega
  double chatter = 0;          ///< [1] share of the mean square that is above the band
  int chatter_node = 0;        ///< contact node with most of it
  double change = 0;           ///< [1] relative change of the motion over the last period, or revolution
  double change_rate = 0;      ///< [1] factor of that change per revolution; below 1 it decays

  bool settled() const { return period_revolutions > 0; }

  Eigen::VectorXd clearance;  ///< [m] at the contact nodes at this speed, spin included; n_c
  /// [m] r, theta, z in the rotor frame, without the static shift; samples x (sector, node, component), the last
  /// index fastest.
  Eigen::MatrixXd displacement;
  /// [N] along -normal, never negative with complementarity; the mean over the sample interval that starts at the
  /// sample; samples x (sector, node).
  Eigen::MatrixXd contact_force;
  /// Steps in contact by area of the casing, over the recorded revolutions; (sector, node) x areas. Area a spans
  /// the absolute angles 2 pi a/areas .. 2 pi (a+1)/areas.
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic> contact_count;
  /// At the recorded sample with the largest contact force, the first of equals; files may come without.
  std::optional<RotorSnapshot> snapshot;
  std::optional<RotorCycle> cycle;  ///< where it was asked for

  EnergyLedger energy;
  double step_ratio = 0;              ///< h omega_max / 2; central differences hold below 1
  double largest_penetration = 0;     ///< [m] of any node, over the recorded revolutions; 0 if none
  double smallest_multiplier = 0;     ///< [N] below zero where the casing pulled
  std::int64_t contact_steps = 0;     ///< recorded steps with at least one closed node
  std::int64_t tension_steps = 0;     ///< recorded steps with a negative multiplier (only the paper's rule has them)
  std::int64_t solver_fallbacks = 0;  ///< steps in which the active set needed its finite fallback
  SpeedAudit audit;
  std::vector<OtherStart> other_starts;  ///< of an examined speed
};

/// How exact a case asks motions to be; all [1].
struct AskedAccuracy {
  double critical_speeds = 0.02;  ///< of a critical speed's amplitude, beside what the mesh leaves open
  double step = 5e-3;             ///< of a settled motion: what the last halving of the step may change
  double settling = 1e-4;         ///< of a settled motion: what may still be to come
};

/// The casing and the scene as they were simulated, for drawing and for the record.
struct SimulatedScene {
  AskedAccuracy asked;                 ///< how exact the motions were to be
  int sector_count = 0;                ///< N
  int independent_sectors = 0;         ///< N / g
  std::vector<int> nodal_diameters;    ///< those that move
  Eigen::VectorXd casing_angle;        ///< [rad] 0 .. 2 pi
  Eigen::VectorXd casing_distortion;   ///< [m] inward, at these angles, after the ramp
  int lobes = 0;                       ///< N_l: the casing repeats every 2 pi / lobes
  std::optional<Scheme> scheme;        ///< none if the file doesn't tell
  std::optional<ContactRule> contact;  ///< likewise
  DampingRatios damping;               ///< empty if the file doesn't tell
  /// [Hz] the upper end of the band that motions are classified in; infinite: all that the samples resolve
  double resolved_frequency = std::numeric_limits<double>::infinity();
  Eigen::VectorXd clearance;  ///< [m] cold or running as the case says, at the contact nodes
  ClearanceState clearance_state = ClearanceState::running;
  std::vector<ModelledEffect> effects;  ///< what of the scene was modelled; empty if the file doesn't tell
  std::string model_digest;             ///< digest() of the model that was marched
  std::string scope;                    ///< what was modelled, what was left out, and why; one reason a line
  std::string casing;                   ///< the table [casing] of the case, as TOML
  std::string provenance;               ///< the case and the chain that made it, as text
};

/// Orbits that hang together over speed, stable and unstable ones, in the order of their arc length. Arrays over the
/// orbits.
struct OrbitBranch {
  double start = 0;                        ///< [rad/s] the speed at which it was met first
  int steps_per_revolution = 0;            ///< of the march whose orbits they are
  std::string ends[2];                     ///< why it ends at its first orbit, and at its last
  Eigen::VectorXd speed;                   ///< [rad/s]
  Eigen::VectorXd amplitude;               ///< [m] as SpeedResponse has it
  Eigen::VectorXd multiplier;              ///< [1] magnitude of the largest Floquet multiplier per revolution
  Eigen::VectorXd multiplier_uncertainty;  ///< [1]
  Eigen::VectorXd multiplier_angle;        ///< [rad] a map, 0 .. pi
  Eigen::VectorXd folds;                   ///< [rad/s] where it turns back in speed; may be empty

  bool attracts(Eigen::Index orbit) const { return multiplier[orbit] < 1; }
};

/// [m] The smallest and the largest of a clearance.
struct ClearanceRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

/// response.h5 in memory. Schema "tiprub-response".
struct Response {
  SimulatedScene scene;
  std::string key;  ///< names all that decides a speed's result (model, casing, scheme): equal keys, equal results
  std::vector<SpeedResponse> speeds;       ///< ascending in speed
  FrequencyTable frequencies = {};         ///< empty in the parts of an unfinished sweep
  std::vector<OrbitBranch> branches = {};  ///< where they were asked for

  /// Over all contact nodes and all speeds that have a response.
  ClearanceRange clearances() const {
    ClearanceRange range;
    for (const SpeedResponse& response : speeds)
      for (const double clearance : response.clearance)
        range = {std::min(range.low, clearance), std::max(range.high, clearance)};
    return range;
  }
};

}  // namespace tiprub
