// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// One row a speed, failed ones included: how steady, how exact, how much contact; speeds.csv.
Table speed_record(const Study& study);

}  // namespace tiprub
