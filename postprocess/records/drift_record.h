// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// How the contact moves with speed: the lines through the middles of both edges' contact, and how late the leading
/// edge's force comes; contact_drift.csv.
Table drift_record(const Study& study);

}  // namespace tiprub
