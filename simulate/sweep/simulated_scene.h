// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "simulate/response/response.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// What response.h5 tells of a scene. `provenance`: the case and the model's, as text.
SimulatedScene simulated_scene(const Scene& scene, const std::string& provenance);

}  // namespace tiprub
