// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/marched_scene.h"

#include "cases/program/text.h"
#include "simulate/motion/attempt.h"

namespace tiprub::simulate {

namespace {

/// [m] what is left of the clearance at a speed in rad/s.
Eigen::VectorXd open_clearance(const Scene& scene, double speed) {
  Eigen::VectorXd clearance = scene.casing.running_clearance(scene.model.contact, speed);
  Eigen::Index node = 0;
  if (clearance.minCoeff(&node) >= 0) return clearance;
  throw NoMotion(text_of("spin closes the clearance: contact node ", node, " (from 0, leading edge first",
                         (node > scene.model.contact.trailing_edge() ? "; on the splitter" : ""), ") is left with ",
                         clearance[node], " m at ", speed,
                         " rad/s; widen [casing] clearance, or give the running one"));
}

}  // namespace

double MarchedScene::omega_max() const {
  return traits_of(setup.scheme).springs ? penalised_omega_max(*rotor, setup.penalty_stiffness) : rotor->omega_max;
}

SharedRotor rotor_of(const Scene& scene, double speed, OtherDiameters others) {
  const SimulateParameters& parameters = scene.parameters;
  // The springs of a penalty are scaled by the stiffness of a tip, to which all nodal diameters contribute.
  if (traits_of(parameters.scheme).springs) others = OtherDiameters::known;
  const ModeChoice modes{
      parameters.modes,
      traits_of(parameters.scheme).quasi_static ? ModeChoice::Others::quasi_static : ModeChoice::Others::dropped,
      parameters.resolved_frequency};
  return std::make_shared<RotorAtSpeed>(
      rotor_at_speed(scene.model, speed, scene.scope.nodal_diameters, parameters.damping, modes, others));
}

MarchedScene marched_scene(const Scene& scene, const SharedRotor& rotor, int steps_per_revolution) {
  const SimulateParameters& parameters = scene.parameters;
  const ContactLine& tips = scene.model.contact;
  return {rotor,
          tips,
          {scene.casing, tips, open_clearance(scene, rotor->speed)},
          {parameters.scheme, parameters.contact, steps_per_revolution, scene.scope.symmetry, parameters.theta,
           parameters.penalty_stiffness * rotor->tip_stiffness,
           scene.casing.has_friction() ? scene.casing.friction_at(tips) : Eigen::VectorXd(), parameters.gap}};
}

}  // namespace tiprub::simulate
