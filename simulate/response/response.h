// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reduce/model/modelled_effects.h"
#include "simulate/motion/motion.h"
#include "simulate/motion/scene_choices.h"

namespace tiprub {

struct ContactLine;

/// "periodic", "subharmonic 1/3", "broadband", ...
std::string motion_text(MotionClass motion, int period_beats);

/// Checks of the result at a speed, beside the energy ledger and the settling.
struct SpeedAudit {
  /// [1] relative difference to the same speed with half the step; absent where no step was halved
  std::optional<double> halving_difference;
  /// [1] the error of the step, estimated from all halvings, over step_tolerance: above 1 the tolerance was not
  /// reached; absent where the case gives the step
  std::optional<double> step_reached;
  std::optional<MotionMeasure> halving_measure;  ///< how that difference was measured
  std::string halving_failure;                   ///< empty, or why half the step gave no motion
  /// [1] factor per revolution of a small disturbance of the nodal diameters left out for symmetry
  std::optional<double> excluded_growth;
  std::optional<double> excluded_growth_uncertainty;  ///< [1] uncertainty of that factor
  SymmetryVerdict symmetry = SymmetryVerdict::all_held;
  /// [1] relative difference to the same speed from rest, for a sweep that carries its state along
  std::optional<double> rest_difference;
  OrbitReport orbit;
  double compliance_condition = 0;  ///< [1] condition number of W
};

/// A start from which a critical speed is marched again.
enum class Start {
  up,           ///< from the motion at the speed 1 % below
  down,         ///< from the motion at the speed 1 % above
  disturbed,    ///< from the settled motion with twice the displacement
  whole_wheel,  ///< from rest with all nodal diameters, where symmetry does not clearly hold
};
template <>
inline constexpr NamedValues<Start, 4> names_of<Start> = {{
    {Start::up, "up"},
    {Start::down, "down"},
    {Start::disturbed, "disturbed"},
    {Start::whole_wheel, "whole wheel"},
}};

/// [m] How far the contact nodes of each blade move from the middle of their paths, over the blades of the wheel.
struct BladeExcursions {
  double least = 0, median = 0, largest = 0;
  bool operator==(const BladeExcursions&) const = default;
};

/// Each as largest_excursion().
BladeExcursions blade_excursions(const Eigen::MatrixXd& displacement, const ContactLine& contact);

/// The motion of a critical speed from another start.
struct OtherStart {
  Start start = Start::up;
  std::string failure;                    ///< empty, or why there is no motion; then the other numbers mean nothing
  double amplitude = 0;                   ///< [m] as SpeedResponse::amplitude
  std::optional<BladeExcursions> blades;  ///< files of older programs have none
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;
  double difference = 0;  ///< [1] relative difference to the motion of the speed itself
};

/// What an error budget varies, because a designer does not know it exactly.
enum class Variation {
  friction,   ///< its coefficient [1]
  damping,    ///< its ratio in all resolved modes [1]
  clearance,  ///< a change of the clearance of all blades [m]
  gap,        ///< the order of the gap in the displacements [1]
  step,       ///< steps in a revolution, twice those of the speed [1]
  model,      ///< another model of the wheel, by the segments of each main blade; 0: contact at points
};
template <>
inline constexpr NamedValues<Variation, 6> names_of<Variation> = {{
    {Variation::friction, "friction"},
    {Variation::damping, "damping"},
    {Variation::clearance, "clearance"},
    {Variation::gap, "gap"},
    {Variation::step, "step"},
    {Variation::model, "model"},
}};

/// The peak of a critical speed with one thing varied.
struct PeakVariation {
  Variation what = Variation::friction;
  double setting = 0;
  std::string failure;   ///< empty, or why the peak was not found; then the numbers below mean nothing
  double speed = 0;      ///< [rad/s] of the peak
  double amplitude = 0;  ///< [m] as SpeedResponse::amplitude, at the peak
  double excursion = 0;  ///< [m] as largest_excursion(), at the peak
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;
  int samples_per_revolution = 0;
  std::string model_digest;         ///< digest() of the model that was marched, if that is not the model of the scene
  std::optional<RotorCycle> cycle;  ///< one period of a motion that repeats, some revolutions of another
};

/// [m] How far the tip moves from the middle of its path, where it moves farthest: the largest of all contact nodes
/// and sectors, and of the edges of blades with contact on segments. The displacement of a segment is a mean, which
/// the corner of a blade exceeds by a tenth or more; that of an edge is the value there of the parabola along the tip
/// that has the means of the three outermost segments (of a straight line or a constant, if there are fewer than
/// four). `displacement` as SpeedResponse has it.
double largest_excursion(const Eigen::MatrixXd& displacement, const ContactLine& contact);

/// How thoroughly a speed was computed.
enum class Depth {
  scanned,   ///< with a coarse step, for its amplitude only; not in a finished response
  full,      ///< within the tolerances
  examined,  ///< also from other starts, with the whole cycle kept
  budgeted,  ///< also with its error budget
};
template <>
inline constexpr NamedValues<Depth, 4> names_of<Depth> = {{
    {Depth::scanned, "scanned"},
    {Depth::full, "full"},
    {Depth::examined, "examined"},
    {Depth::budgeted, "budgeted"},
}};

/// The settled response at one speed. Recorded sample s lies at the rotor angle 2 pi s / samples_per_revolution. Only
/// the first `independent_sectors` = N / g sectors are kept, with g = gcd(N, lobes): sector j moves as sector
/// j mod (N / g) at every instant.
struct SpeedResponse : RecordedMotion {
  double speed = 0;     ///< [rad/s]
  std::string failure;  ///< empty, or why this speed has no response; then the arrays are empty
  int steps_per_revolution = 0;
  int revolutions = 0;  ///< marched in all, the recorded ones included
  Depth depth = Depth::full;
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;        ///< period of a periodic (1) or subharmonic motion, else 0
  int period_revolutions = 0;  ///< period of a settled motion; 0 if it has not settled
  double off_beat_energy = 0;  ///< [1] share of the mean square in the band that is at no multiple of lobes x Omega
  double change = 0;           ///< [1] relative change of the motion over the last period, or revolution
  double change_rate = 0;      ///< [1] factor of that change per revolution; below 1 it decays

  bool settled() const { return period_revolutions > 0; }

  Eigen::VectorXd clearance;          ///< [m] at the contact nodes at this speed, spin included; n_c
  double step_ratio = 0;              ///< h omega_max / 2; central differences are stable below 1
  std::int64_t solver_fallbacks = 0;  ///< steps in which the active-set method cycled and Murty's method took over
  SpeedAudit audit;
  std::vector<OtherStart> other_starts;  ///< of an examined speed
  std::vector<PeakVariation> budget;     ///< likewise, if the case asks for it
};

/// The tolerances of a case; all [1].
struct AskedAccuracy {
  double critical_speeds = 0.02;  ///< of the amplitude of a critical speed, the error of the mesh excluded
  double step = 5e-3;             ///< of a settled motion: its allowed change by the last halving of the step
  double settling = 1e-4;         ///< of a settled motion: its allowed distance from the limit
};

/// The casing and the scene as they were simulated, for drawing and for the record.
struct SimulatedScene {
  AskedAccuracy asked;                ///< the tolerances of the case
  int sector_count = 0;               ///< N
  int independent_sectors = 0;        ///< N / g
  std::vector<int> nodal_diameters;   ///< those that were marched
  Eigen::VectorXd casing_angle;       ///< [rad] 0 .. 2 pi
  Eigen::VectorXd casing_distortion;  ///< [m] inward, at these angles, after the ramp; the largest of the nodes'
  /// [m] The same for each contact node, angles x n_c, and its largest value there; empty if all nodes meet the same.
  Eigen::MatrixXd node_distortion;
  Eigen::VectorXd node_crest;
  /// [m] the largest distortion, which may lie between these angles; empty if the file has none
  std::optional<double> largest_distortion;
  int lobes = 0;                       ///< N_l: the casing repeats every 2 pi / lobes
  std::optional<Scheme> scheme;        ///< empty if the file has none
  std::optional<ContactRule> contact;  ///< likewise
  DampingRatios damping;               ///< empty if the file has none
  /// [Hz] the upper end of the band in which motions are classified; infinite: all that the samples resolve
  double resolved_frequency = std::numeric_limits<double>::infinity();
  Eigen::VectorXd clearance;  ///< [m] cold or running as the case says, at the contact nodes
  ClearanceState clearance_state = ClearanceState::running;
  std::vector<ModelledEffect> effects;  ///< what was modelled and left out; empty if the file has none
  std::string model_digest;             ///< digest() of the model that was marched
  std::string scope;                    ///< what was modelled and left out, and why; one reason per line
  std::string casing;                   ///< the table [casing] of the case, as TOML
  std::string provenance;               ///< the case and the provenance of the model, as text

  double crest() const { return largest_distortion.value_or(casing_distortion.maxCoeff()); }  ///< [m] inward
  /// [m] Inward, at the angles, over a contact node.
  Eigen::VectorXd distortion_over(int node) const;
  /// [m] The crest over each contact node minus its clearance: how far the casing stands into a tip that spins and
  /// does not vibrate.
  Eigen::VectorXd interference(const Eigen::VectorXd& running_clearance) const;
  /// The case in the provenance, with the settings of its sweep.
  std::string swept_case() const { return provenance.substr(0, provenance.find("\n# model\n")); }
};

/// A connected curve of orbits over speed, stable and unstable, in the order of arc length. Arrays over the orbits.
struct OrbitBranch {
  double start = 0;                        ///< [rad/s] the speed at which the branch was begun
  int steps_per_revolution = 0;            ///< of the march
  std::array<std::string, 2> ends;         ///< why it ends at its first orbit, and at its last
  Eigen::VectorXd speed;                   ///< [rad/s]
  Eigen::VectorXd amplitude;               ///< [m] as SpeedResponse::amplitude
  Eigen::VectorXd multiplier;              ///< [1] magnitude of the largest Floquet multiplier per revolution
  Eigen::VectorXd multiplier_uncertainty;  ///< [1]
  Eigen::VectorXd multiplier_angle;        ///< [rad] of one map, 0 .. pi
  Eigen::VectorXd folds;                   ///< [rad/s] speeds at which the branch turns back; may be empty

  bool attracts(Eigen::Index orbit) const { return multiplier[orbit] < 1; }
};

/// [m] The smallest and the largest of some lengths.
struct LengthRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

/// response.h5 in memory. Schema "tiprub-response".
struct Response {
  SimulatedScene scene;
  std::string key;                          ///< identifies everything that decides the result of a speed (run_key)
  std::vector<SpeedResponse> speeds;        ///< ascending in speed
  FrequencyTable frequencies = {};          ///< empty in the parts of an unfinished sweep
  std::vector<OrbitBranch> branches = {};   ///< empty unless the case asks for them
  Eigen::VectorXd scanned_speeds = {};      ///< [rad/s] ascending: where an adaptive sweep marched with a coarse step
  Eigen::VectorXd scanned_amplitudes = {};  ///< [m] there; negative where the march failed

  /// Over all contact nodes and all speeds that have a response.
  LengthRange clearances() const {
    LengthRange range;
    for (const SpeedResponse& response : speeds)
      for (const double clearance : response.clearance)
        range = {std::min(range.low, clearance), std::max(range.high, clearance)};
    return range;
  }
};

}  // namespace tiprub
