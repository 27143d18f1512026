// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace tiprub {

/// What moves, in the band of resolved frequencies, when a speed is left. A beat is 1/lobes of a revolution: the time
/// after which a blade meets the same casing again.
enum class MotionClass {
  periodic,     ///< the same every beat
  subharmonic,  ///< the same every `period_beats` beats
  modulated,    ///< a few lines beside the multiples of the beat's frequency
  broadband,    ///< energy spread between them
  not_settled,  ///< still on its way: what will be can't be told yet
};

/// Whether a class names a motion that repeats itself.
constexpr bool repeats(MotionClass motion) {
  return motion == MotionClass::periodic || motion == MotionClass::subharmonic;
}

/// What two motions of a speed are compared by.
enum class MotionMeasure {
  motion,    ///< sample by sample: both repeat themselves alike
  spectrum,  ///< amplitudes of engine orders: trajectories that never repeat mean nothing
};

/// Where the energy of a speed went, over the recorded revolutions.
struct EnergyLedger {
  double contact_work = 0;   ///< [J] done by the casing on the rotor
  double dissipated = 0;     ///< [J] taken by damping
  double energy_change = 0;  ///< [J] of kinetic and elastic energy, end minus start
  double closing_error = 0;  ///< [1] (work - dissipated - change) over the largest of the three
};

/// How the settled motion was found, if it was looked for as an orbit.
struct OrbitReport {
  enum class Outcome {
    none,     ///< not asked for, or not possible
    found,    ///< by Newton's method: stable, and confirmed by marching
    marched,  ///< Newton's method found nothing, or what repels: the march went on from before it
  };

  Outcome outcome = Outcome::none;
  int maps = 1;            ///< of 1/lcm(N, lobes) of a revolution each, after which it repeats itself
  double revolutions = 0;  ///< that all maps come to, the linearised ones too
  double residual = 0;     ///< [1] change of the state by the map, of its size
  /// [1] of the largest Floquet multiplier, per revolution: its magnitude, and how exactly that is known; 0: not
  /// known
  double multiplier = 0, multiplier_uncertainty = 0;
  double multiplier_angle = 0;  ///< [rad] 0 .. pi, of a map: pi for a flip
};

/// Whether the nodal diameters left out for symmetry would have stayed at rest.
enum class SymmetryVerdict {
  all_held,   ///< none was left out
  unchecked,  ///< not looked at
  holds,      ///< a small disturbance of them dies out
  breaking,   ///< it grows: the motion found is not the one that nature would show
  undecided,  ///< it neither clearly grows nor clearly dies out
};

/// The natural frequencies of the model that was marched, condensed at each speed (reduce/model/condensation.h).
struct FrequencyTable {
  Eigen::VectorXd speed;  ///< [rad/s] even, from 0 to the highest speed of the sweep
  /// [Hz] one a nodal diameter 0 .. N/2, moving or not; speeds x modes, ascending in a row; negative,
  /// -sqrt(-omega^2), where the rotor is statically unstable.
  std::vector<Eigen::MatrixXd> by_nodal_diameter;
  /// [1] of critical, of the same modes: what the march gives a mode of that family and frequency; empty if the file
  /// doesn't tell
  std::vector<Eigen::MatrixXd> damping_ratio = {};
};

}  // namespace tiprub
