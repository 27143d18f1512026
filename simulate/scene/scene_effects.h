// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reduce/model/modelled_effects.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// What a scene models of the effects on a wheel that rubs, and what it simplifies or leaves out.
std::vector<ModelledEffect> effects_of(const Scene& scene);

}  // namespace tiprub
