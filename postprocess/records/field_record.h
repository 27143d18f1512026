// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/fields/field_study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// The largest stress at every speed whose fields were recovered, and its place in full.
Table stress_peak_record(const FieldStudy& fields);

/// The frequency of every natural mode that was looked at, and how much each part of the wheel takes part in it.
Table mode_record(const FieldStudy& fields);

}  // namespace tiprub
