// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/fields/field_peak.h"
#include "postprocess/fields/node_stress.h"
#include "reduce/model/fields_file.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// Checks that the fields are of the model that the error budgets of the response compare with ([simulate]
/// budget_model); a response without critical speeds has no budgets. Raises InputError if they are not, or if a cell
/// has no stress.
void check_budget_fields(const FieldsReader& other, const Response& response);

/// The nodes in the body of another mesh of the same sector whose nearest node in `sector` is one of `nodes`;
/// ascending.
std::vector<int> nodes_near(const std::vector<int>& nodes, const SectorFields& sector, const SectorFields& other,
                            const StressZones& zones_of_other);

/// The stress over the cycles of varied peaks that were marched with another model, near `nodes` of the sector.
/// Raises InputError if the other mesh has no node there.
LargestStress stress_of_other_model(const FieldsReader& other, const SectorFields& sector,
                                    const std::vector<int>& nodes, const StressZones& zones,
                                    const SimulatedScene& scene);

}  // namespace tiprub::postprocess
