// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/speed/speed_run.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::testing {

/// A scene that owns its parts, for the checks that a whole speed goes through.
struct OwnedScene {
  ReducedModel model;
  Casing casing;
  SimulateParameters parameters;
  SceneScope scope;

  Scene view() const { return {model, casing, parameters, scope}; }
};

/// Few revolutions, no extra checks; steps a revolution as given.
inline OwnedScene owned_scene(ReducedModel model, Casing casing, int steps_per_revolution,
                              SimulateParameters parameters = {}) {
  parameters.damping = {0.01};
  parameters.steps_per_revolution = steps_per_revolution;
  parameters.samples_per_revolution = 60;
  parameters.recorded_revolutions = 2;
  parameters.min_revolutions = 10;
  parameters.max_revolutions = 40;
  parameters.settle_tolerance = 1e-3;
  parameters.casing_areas = 10;
  const SceneScope scope = find_scope(model.sector_count, casing.lobes, parameters);
  return {std::move(model), std::move(casing), parameters, scope};
}

/// A casing without lobes at a distance [m] from a node at rest; negative: it presses always.
inline Casing round_wall(double distance) {
  return lobed_casing(1, 0.0, distance);
}

}  // namespace tiprub::simulate::testing
