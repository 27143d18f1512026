// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "simulate/response/response.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// The origin of a scene, as text.
struct SceneOrigin {
  std::string provenance;  ///< the case, and the provenance of the model
  std::string casing;      ///< the table [casing] as the case has it (CaseTable::written())
};

/// The description of a scene in response.h5.
SimulatedScene simulated_scene(const Scene& scene, const SceneOrigin& origin);

}  // namespace tiprub
