// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "simulate/response/response.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// Where a scene comes from, as text.
struct SceneOrigin {
  std::string provenance;  ///< the case, and the model's
  std::string casing;      ///< the table [casing] as the case has it (CaseTable::written())
};

/// What response.h5 tells of a scene.
SimulatedScene simulated_scene(const Scene& scene, const SceneOrigin& origin);

}  // namespace tiprub
