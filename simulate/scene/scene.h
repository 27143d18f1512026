// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/scene_scope.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub {

/// All that a sweep's speeds have in common.
struct Scene {
  const ReducedModel& model;
  const Casing& casing;
  const SimulateParameters& parameters;
  const SceneScope& scope;
};

/// [m] amplitude and clearance of a scene: what its motions are measured by.
inline double length_scale(const Scene& scene) {
  return scene.casing.amplitude + scene.casing.given_clearance(scene.model.contact).maxCoeff();
}

}  // namespace tiprub
