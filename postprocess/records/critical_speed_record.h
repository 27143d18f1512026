// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_results.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// The critical speeds with every digit and unit, for critical_speeds.csv. Stresses are empty without full fields.
Table critical_speed_record(const Study& study, const FieldResults& fields);
/// The same for people: fewer columns, rounded; no stresses without full fields.
Table critical_speed_overview(const Study& study, const FieldResults& fields);
/// Its two halves, for a page that isn't wide enough for both side by side: the motion; the stress, with the speed.
Table critical_speed_motions(const Study& study);
Table critical_speed_stresses(const Study& study, const FieldResults& fields);

}  // namespace tiprub
