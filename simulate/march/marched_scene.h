// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "reduce/model/reduced_model.h"
#include "simulate/march/rotor_at_speed.h"
#include "simulate/motion/scene_choices.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/scene.h"

namespace tiprub::simulate {

/// How a march is to be done.
struct MarchSetup {
  Scheme scheme = Scheme::trigonometric;
  ContactRule contact = ContactRule::complementarity;
  int steps_per_revolution = 0;  ///< a multiple of N and of the casing's lobes
  int symmetry = 1;              ///< g: the wheel's nodal diameters are multiples of it
  double theta = 0.5;            ///< [1] of Moreau-Jean
  double penalty_stiffness = 0;  ///< [N/m] of penalty
  /// [1] mu of the contact nodes of a blade, or one for all of them; empty: none
  Eigen::VectorXd friction = {};
  GapOrder gap = GapOrder::linear;
};

/// All marches of one speed share a rotor.
using SharedRotor = std::shared_ptr<const RotorAtSpeed>;

/// The ingredients of a march: what moves, what the tips meet, and how time is stepped.
struct MarchedScene {
  SharedRotor rotor;  ///< its WaveModes hold the motion of the tips along the normals and in r, theta, z
  ContactLine tips;
  Obstacle obstacle;
  MarchSetup setup;

  /// [rad/s] the highest frequency of the modes; if closed tips stand on springs, with all springs attached.
  double omega_max() const;
};

/// The rotor of a scene at a speed [rad/s]. Raises NoMotion if it is unstable there.
SharedRotor rotor_of(const Scene& scene, double speed, OtherDiameters others = OtherDiameters::known);

/// Collects what a scene's march at the speed of the rotor needs. Raises NoMotion if spin closes the clearance there.
MarchedScene marched_scene(const Scene& scene, const SharedRotor& rotor, int steps_per_revolution);

}  // namespace tiprub::simulate
