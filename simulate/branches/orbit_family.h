// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "simulate/march/marched_scene.h"
#include "simulate/periodic/periodic_map.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// The symmetric map of a scene at any speed, with one step for all speeds (a share of a revolution), on states that
/// mean the same at all of them: modes change with the speed, cross, and take any phase, so that each speed's are
/// turned to stand as those of a reference speed do. With Phi the modes of a nodal diameter at a speed and Phi_0
/// those at the reference speed,
///   z = U q,   U the unitary part of Phi_0^H M Phi (its polar factor),
/// is that turn; positions are then scaled by the reference frequencies, velocities by the ratio of the speeds, so
/// that a harmonic keeps its engine order.
class OrbitFamily {
 public:
  /// Refers to the scene. Raises NoMotion if the rotor is unstable at the reference speed.
  OrbitFamily(const Scene& scene, double reference_speed, int steps_per_revolution);

  /// At a speed in rad/s; the last few are kept. Raises NoMotion if the rotor is unstable there, or spin closes the
  /// clearance.
  std::shared_ptr<PeriodicMap> at(double speed);
  /// [m] half of the peak-to-peak normal displacement of the orbit through a state, as SpeedResponse has it.
  double amplitude(double speed, const Eigen::VectorXd& state);
  double maps_per_revolution() const;
  /// A state of SymmetricMap's, at a speed, as one of this family; and back.
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

}  // namespace tiprub
