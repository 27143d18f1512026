// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// Every orbit of every branch, in the order in which they hang together: branches.csv. Needs branches.
Table branch_record(const Study& study);

}  // namespace tiprub
