// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <optional>
#include <vector>

#include "cases/program/named_values.h"

namespace tiprub {

/// The names of an enumeration in response.h5. The list is empty unless an enumeration has its own below.
template <class Value>
inline constexpr NamedValues<Value, 0> names_of = {};

template <class Value>
requires(!names_of<Value>.empty()) constexpr const char* name_of(Value value) {
  return name_in(names_of<Value>, value);
}

/// The class of a motion, up to the resolved frequency, at the end of the march. A beat is 1/lobes of a
/// revolution: the time after which a blade meets the same shape of the casing again.
enum class MotionClass {
  periodic,     ///< the same every beat
  subharmonic,  ///< the same every `period_beats` beats
  modulated,    ///< a few spectral lines beside the multiples of the beat frequency
  broadband,    ///< energy spread between the multiples of the beat frequency
  not_settled,  ///< still changing: its final class is not known yet
};
template <>
inline constexpr NamedValues<MotionClass, 5> names_of<MotionClass> = {{
    {MotionClass::periodic, "periodic"},
    {MotionClass::subharmonic, "subharmonic"},
    {MotionClass::modulated, "modulated"},
    {MotionClass::broadband, "broadband"},
    {MotionClass::not_settled, "not settled"},
}};

/// Whether a class names a motion that repeats itself.
constexpr bool repeats(MotionClass motion) {
  return motion == MotionClass::periodic || motion == MotionClass::subharmonic;
}

/// How two motions of a speed are compared.
enum class MotionMeasure {
  motion,    ///< sample by sample: both have settled with the same period
  spectrum,  ///< by amplitudes of engine orders: at least one of the two does not repeat itself
};
template <>
inline constexpr NamedValues<MotionMeasure, 2> names_of<MotionMeasure> = {{
    {MotionMeasure::motion, "motion"},
    {MotionMeasure::spectrum, "spectrum"},
}};

/// The energy balance of a speed over the recorded revolutions.
struct EnergyLedger {
  double contact_work = 0;   ///< [J] done by the casing on the rotor
  double drag_work = 0;      ///< [J] the part of it that friction does, on the vibration
  double dissipated = 0;     ///< [J] taken by damping
  double energy_change = 0;  ///< [J] of kinetic and elastic energy, end minus start
  double closing_error = 0;  ///< [1] (work - dissipated - change) over the largest of the three
};

/// What friction does over the recorded revolutions; all absent without friction. The largest values are means over
/// the interval of a sample.
struct FrictionLoad {
  std::optional<double> drag_work;                                      ///< [J] EnergyLedger::drag_work
  std::optional<double> blade_drag_mean, blade_drag_largest;            ///< [N] mu lambda, summed over a blade
  std::optional<double> rub_torque_mean, rub_torque_largest;            ///< [N m] against the wheel, about its axis
  std::optional<double> rub_power_mean, rub_power_largest;              ///< [W] that torque times Omega
  std::optional<double> blade_rub_power_mean, blade_rub_power_largest;  ///< [W] of one blade
};

/// How the settled motion was found, if the case asked for a search for an orbit.
struct OrbitReport {
  enum class Outcome {
    none,     ///< no search was asked for, or none is possible
    found,    ///< by Newton's method: stable, and confirmed by marching
    marched,  ///< Newton's method found no stable orbit; the march continued from the state before it
  };

  Outcome outcome = Outcome::none;
  int maps = 1;            ///< period of the orbit in maps of 1/lcm(N, lobes) of a revolution each
  double revolutions = 0;  ///< total cost of all maps, the linearised ones included
  double residual = 0;     ///< [1] change of the state by the map, relative to the state
  /// [1] The magnitude of the largest Floquet multiplier per revolution, and its uncertainty; 0 if not known.
  double multiplier = 0, multiplier_uncertainty = 0;
  double multiplier_angle = 0;  ///< [rad] 0 .. pi, of one map: pi for a period doubling

  bool operator==(const OrbitReport&) const = default;
};
template <>
inline constexpr NamedValues<OrbitReport::Outcome, 3> names_of<OrbitReport::Outcome> = {{
    {OrbitReport::Outcome::none, "none"},
    {OrbitReport::Outcome::found, "found"},
    {OrbitReport::Outcome::marched, "marched"},
}};

/// Whether the nodal diameters that were left out by symmetry would stay at rest.
enum class SymmetryVerdict {
  all_held,   ///< no nodal diameter was left out
  unchecked,  ///< their growth was not computed
  holds,      ///< a small disturbance of a periodic motion by them dies out; a larger one need not
  breaking,   ///< it grows: the computed motion would not be observed
  undecided,  ///< it neither clearly grows nor clearly dies out, or the motion has no period
};
template <>
inline constexpr NamedValues<SymmetryVerdict, 5> names_of<SymmetryVerdict> = {{
    {SymmetryVerdict::all_held, "all held"},
    {SymmetryVerdict::unchecked, "unchecked"},
    {SymmetryVerdict::holds, "holds"},
    {SymmetryVerdict::breaking, "breaking"},
    {SymmetryVerdict::undecided, "undecided"},
}};

/// The natural frequencies of the model that was marched, condensed at each speed (reduce/model/condensation.h).
struct FrequencyTable {
  Eigen::VectorXd speed;  ///< [rad/s] even, from 0 to the highest speed of the sweep
  /// [Hz] one matrix for each nodal diameter 0 .. N/2, marched or not; speeds x modes, ascending in a row; negative,
  /// -sqrt(-omega^2), where the rotor is statically unstable.
  std::vector<Eigen::MatrixXd> by_nodal_diameter;
  /// [1] of critical, for the same modes: the damping with which a mode of that family and frequency is marched;
  /// empty if the file has none
  std::vector<Eigen::MatrixXd> damping_ratio = {};
};

/// The state of a wheel after whole revolutions, in the coordinates of the model, so that a march at another speed,
/// whose modes differ, can start from it. Velocities are per radian of rotation, so that a harmonic keeps its engine
/// order.
struct RotorState {
  std::vector<Eigen::VectorXcd> displacement;  ///< [m in contact rows] by nodal diameter 0 .. N/2; empty: at rest
  std::vector<Eigen::VectorXcd> velocity;      ///< [m/rad in contact rows] likewise

  bool at_rest() const { return displacement.empty(); }
};

/// The whole rotor at one instant, in the dofs of the reduced model. Full fields are recovered from it.
struct RotorSnapshot {
  int sample = 0;  ///< the recorded sample; the rotor angle is 2 pi sample / samples_per_revolution
  double force =
      0;  ///< [N] sum of the contact forces' magnitudes over all N sectors, mean over the sample's interval
  /// [m in contact rows] by nodal diameter, in the order of those that move: u_j = Re(sum over n of x_n e^{i n j
  /// alpha}). Contact dofs first, then generalized ones, as in model.h5.
  std::vector<Eigen::VectorXcd> displacement;
};

/// The whole rotor over the last recorded revolutions, sample by sample, from which stress over a cycle is computed.
/// It is kept for examined speeds only.
struct RotorCycle {
  int first_sample = 0;  ///< recorded sample of the first column; the last column is the last sample
  /// [m in contact rows] by nodal diameter, dofs x samples; each column as RotorSnapshot::displacement.
  std::vector<Eigen::MatrixXcd> displacement;
};

/// Some revolutions of a march, sample by sample, and the numbers that were collected with them.
struct RecordedMotion {
  int samples_per_revolution = 0;
  int recorded_revolutions = 0;  ///< as the case says, or one period of a settled motion if that is less
  /// [m] r, theta, z in the rotor frame, without the static shift; samples x (sector, node, component), the last
  /// index fastest.
  Eigen::MatrixXd displacement;
  /// [N] along -normal, never negative with complementarity; the mean over the sample interval that starts at the
  /// sample; samples x (sector, node).
  Eigen::MatrixXd contact_force;
  /// Steps in contact by area of the casing, over the recorded revolutions; (sector, node) x areas. Area a spans
  /// the absolute angles 2 pi a/areas .. 2 pi (a+1)/areas.
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic> contact_count;
  /// At the first recorded sample with the largest contact force; files may have none.
  std::optional<RotorSnapshot> snapshot;
  std::optional<RotorCycle> cycle;  ///< if it was asked for: at examined speeds
  double amplitude = 0;  ///< [m] half of the peak-to-peak normal displacement, largest of all nodes and sectors
  double chatter = 0;    ///< [1] share of the mean square above the band of resolved frequencies
  int chatter_node = 0;  ///< contact node with most chatter
  EnergyLedger energy;
  FrictionLoad friction;
  double largest_penetration = 0;   ///< [m] of any node; 0 if none
  double smallest_multiplier = 0;   ///< [N] below zero where the casing pulled
  std::int64_t contact_steps = 0;   ///< steps with at least one closed node
  std::int64_t tension_steps = 0;   ///< steps with a negative multiplier (with the paper's rule only)
  std::int64_t leftover_steps = 0;  ///< steps that leave a node clearly in the casing
  double tension_share = 0;         ///< [1] share of tensile forces in the sum of the magnitudes of contact forces
  double left_out_energy = 0;       ///< [1] share of the elastic energy in modes without mass or dropped
};

}  // namespace tiprub
