// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "reduce/model/reduced_model.h"
#include "simulate/march/rotor_at_speed.h"
#include "simulate/motion/scene_choices.h"
#include "simulate/scene/obstacle.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// How a march is to be done.
struct MarchSetup {
  Scheme scheme = Scheme::trigonometric;
  ContactRule contact = ContactRule::complementarity;
  int steps_per_revolution = 0;  ///< a multiple of N and of the casing's lobes
  int symmetry = 1;              ///< g: the wheel's nodal diameters are multiples of it
  double theta = 0.5;            ///< [1] of Moreau-Jean
  double penalty_stiffness = 0;  ///< [N/m] of penalty
};

/// Marches of one speed share it.
using SharedRotor = std::shared_ptr<const RotorAtSpeed>;

/// All that a march is made of: what moves, what it meets, and the steps.
struct MarchedScene {
  SharedRotor rotor;  ///< with the tips' motion by mode: along the normals, and in r, theta, z (WaveModes)
  ContactLine tips;
  Obstacle obstacle;
  MarchSetup setup;

  /// [rad/s] the highest frequency that a step meets: of the modes, or, if closed tips stand on springs, with these.
  double omega_max() const;
};

/// The rotor of a scene at a speed [rad/s]. Raises NoMotion if it is unstable there.
SharedRotor rotor_of(const Scene& scene, double speed, OtherDiameters others = OtherDiameters::known);

/// What a scene's march at the rotor's speed is made of. Raises NoMotion if spin closes the clearance there.
MarchedScene marched_scene(const Scene& scene, const SharedRotor& rotor, int steps_per_revolution);

}  // namespace tiprub
