// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// What was checked, a row each: how far off at the worst, at which speed, and at how many speeds it was looked at;
/// exactness.csv.
Table exactness_record(const Study& study);

}  // namespace tiprub
