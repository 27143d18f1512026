// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/simulated_scene.h"

#include <numbers>

#include "reduce/model/reduced_model.h"
#include "simulate/scene/scene_effects.h"

namespace tiprub {

namespace {

constexpr int casing_points = 721;  // of the casing's shape in the response: every half degree

}  // namespace

SimulatedScene simulated_scene(const Scene& scene, const SceneOrigin& origin) {
  SimulatedScene described;
  described.asked = {scene.parameters.accuracy, scene.parameters.step_tolerance, scene.parameters.settle_tolerance};
  described.sector_count = scene.model.sector_count;
  described.independent_sectors = scene.scope.independent_sectors;
  described.nodal_diameters = scene.scope.nodal_diameters;
  described.casing_angle = Eigen::VectorXd::LinSpaced(casing_points, 0.0, 2 * std::numbers::pi);
  const Eigen::VectorXd fractions = arc_fractions(scene.model.contact);
  described.casing_distortion = described.casing_angle.unaryExpr([&](double angle) {
    return fractions.unaryExpr([&](double fraction) { return scene.casing.distortion(angle, fraction); }).maxCoeff();
  });
  described.lobes = scene.casing.lobes;
  described.scheme = scene.parameters.scheme;
  described.contact = scene.parameters.contact;
  described.damping = scene.parameters.damping.ratios();
  described.resolved_frequency = scene.parameters.resolved_frequency;
  described.clearance = scene.casing.given_clearance(scene.model.contact);
  described.clearance_state = scene.casing.clearance_state;
  for (const std::string& reason : scene.scope.reasons) described.scope += reason + "\n";
  described.effects = effects_of(scene);
  described.model_digest = digest(scene.model);
  described.provenance = origin.provenance;
  described.casing = origin.casing;
  return described;
}

}  // namespace tiprub
