// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/reduced_model.h"

namespace tiprub {

/// What makes all results of a model doubtful, for the first line of every summary: "warning: ...; ", or empty. These
/// are a tip that spin moves by more than 2 % of its radius (no metal strains so much: a value is in another unit),
/// and a polynomial K(Omega) that misses frequencies by more than 0.1 %.
std::string doubts(const ReducedModel& model);

}  // namespace tiprub
