// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/reduced_model.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/scene_scope.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub {

/// A name for all that decides the result at a speed: the model's numbers, the casing, the scheme and how it is
/// settled and recorded, and the program's version; not the list of speeds, the threads, or remarks in the case.
/// 16 hexadecimal digits (FNV-1a over the bytes of the values).
std::string run_key(const ReducedModel& model, const Casing& casing, const SimulateParameters& parameters,
                    const std::string& generator);

}  // namespace tiprub
