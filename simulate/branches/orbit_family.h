// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <deque>
#include <memory>
#include <utility>

#include "simulate/march/marched_scene.h"
#include "simulate/periodic/periodic_map.h"
#include "simulate/scene/scene.h"

namespace tiprub::simulate {

/// The symmetric map of a scene at any speed, with the same number of steps in a revolution, on states that have the
/// same meaning at all speeds. Modes change with the speed, cross, and have an arbitrary phase; the modes of each
/// speed are therefore rotated onto those of a reference speed. With Phi the modes of a nodal diameter at a speed and
/// Phi_0 those at the reference speed, the rotated coordinates are
///   z = U q,   U the unitary part of Phi_0^H M Phi (its polar factor).
/// Positions are then scaled by the reference frequencies and velocities by the ratio of the speeds, so that a
/// harmonic keeps its engine order.
class OrbitFamily {
 public:
  /// Refers to the scene. Raises NoMotion if the rotor is unstable at the reference speed.
  OrbitFamily(const Scene& scene, double reference_speed, int steps_per_revolution);

  /// The map at a speed in rad/s; the last few maps are kept. Raises NoMotion if the rotor is unstable there or spin
  /// closes the clearance.
  std::shared_ptr<PeriodicMap> at(double speed);
  /// [m] half of the peak-to-peak normal displacement of the orbit through a state, as SpeedResponse has it.
  double amplitude(double speed, const Eigen::VectorXd& state);
  double maps_per_revolution() const;
  /// Converts a state of SymmetricMap at a speed into a state of this family, and back.
  Eigen::VectorXd of_family(double speed, const Eigen::VectorXd& state);
  Eigen::VectorXd of_march(double speed, const Eigen::VectorXd& state);

 private:
  class MapAtSpeed;
  std::shared_ptr<MapAtSpeed> map(double speed);

  const Scene& scene_;
  SharedRotor reference_;
  int steps_per_revolution_;
  std::deque<std::pair<double, std::shared_ptr<MapAtSpeed>>> kept_;
};

}  // namespace tiprub::simulate
