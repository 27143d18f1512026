// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/reduced_model.h"
#include "simulate/casing.h"
#include "simulate/response.h"
#include "simulate/scene_scope.h"
#include "simulate/simulate_parameters.h"

namespace tiprub {

/// All that a sweep's speeds have in common.
struct Scene {
  const ReducedModel& model;
  const Casing& casing;
  const SimulateParameters& parameters;
  const SceneScope& scope;
};

/// From rest to the settled motion at one speed [rad/s], and its recording. A speed that fails (a clearance closed by
/// spin, an unstable rotor, a step too long for central differences, a motion that grows without bound) comes back
/// with its reason in `failure`; nothing is raised.
SpeedResponse simulate_speed(const Scene& scene, double speed);

}  // namespace tiprub
