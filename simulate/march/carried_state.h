// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"
#include "simulate/march/time_march.h"
#include "simulate/motion/rotor_state.h"

namespace tiprub {

/// What a march is at. Backward difference over the last step: a start for the next settling, no restart.
RotorState state_of(const TimeMarch& march, const ReducedModel& model);

/// Puts a state into a march; the modes that it doesn't keep lose their part.
void put_state(const RotorState& state, const ReducedModel& model, TimeMarch& march);

}  // namespace tiprub
