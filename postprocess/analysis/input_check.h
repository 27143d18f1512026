// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// Raises InputError if the response, its states or its frequencies do not belong to the model, and RunError if the
/// response holds no speed that can be used. `name` is the response's, for messages.
void check_together(const ReducedModel& model, const Response& response, const std::string& name);

/// Raises InputError, with the first line that differs, if the casing of the case (its table [casing], as
/// CaseTable::written() gives it) is not the one that was simulated. `name` is the response's.
void check_casing(const std::string& casing, const SimulatedScene& scene, const std::string& name);

/// Raises RunError if a number of the response is absurdly large (above 1e30 in SI units), as in damaged files.
void check_measures(const Response& response, const std::string& name);

}  // namespace tiprub::postprocess
