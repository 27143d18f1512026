// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// Every speed from rest, swept up and swept down: sweeps.csv. Needs sweeps.
Table sweep_record(const Study& study);

}  // namespace tiprub
