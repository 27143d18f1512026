// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// What the linear rules list (eq. 2; eq. 17 with aliasing), and whether a critical speed was there:
/// linear_criterion.csv. Forward waves that eq. 2 leaves out stand in it as excluded.
Table linear_criterion_record(const Study& study);
/// What each rule was worth, counted and by amplitude: linear_rules.csv.
Table rule_score_record(const Study& study);

}  // namespace tiprub
