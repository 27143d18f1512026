// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/reduced_model.h"

namespace tiprub {

/// Fills in the model's own frequencies beside the unreduced ones, with as many dofs as it has at any one speed.
void find_reduced_frequencies(ReducedModel& model, int threads);

/// How many of the wheel's first frequencies the verification holds at every speed: up to where the modes of some
/// nodal diameter end.
int verified_frequencies(const ReducedModel& model);

/// Largest relative difference of the first `count` frequencies of the whole wheel (nodal diameters strictly between
/// 0 and N/2 count twice) over all verification speeds, model against unreduced sector.
double verification_error(const ReducedModel& model, int count);

}  // namespace tiprub
