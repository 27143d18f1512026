// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// The line through the places that both edges rub: contact_drift.csv.
Table drift_record(const Study& study);

}  // namespace tiprub
