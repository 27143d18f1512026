// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/records/speeds_to_avoid.h"

namespace tiprub::postprocess {

/// The margin of the operating range to the nearest critical speeds, and what is known of the range itself; or that
/// the case gives no operating range. `bands`: all speeds to avoid.
std::string margin_text(const Study& study, const FieldResults& fields, const std::vector<AvoidedBand>& bands);

}  // namespace tiprub::postprocess
