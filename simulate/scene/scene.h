// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/scene_scope.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub {

/// The data that all speeds of a sweep share.
struct Scene {
  const ReducedModel& model;
  const Casing& casing;
  const SimulateParameters& parameters;
  const SceneScope& scope;
};

/// [m] Amplitude plus clearance, the length with which motions of a scene are compared.
inline double length_scale(const Scene& scene) {
  return scene.casing.amplitude + scene.casing.given_clearance(scene.model.contact).maxCoeff();
}

}  // namespace tiprub
