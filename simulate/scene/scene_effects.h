// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reduce/model/modelled_effects.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// Which effects on a rubbing wheel a scene models, which it simplifies, and which it leaves out.
std::vector<ModelledEffect> effects_of(const Scene& scene);

}  // namespace tiprub
