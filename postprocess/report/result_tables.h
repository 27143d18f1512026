// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// The critical speeds with every digit and unit, for critical_speeds.csv. Stresses are empty without full fields.
Table critical_speed_record(const Study& study);
/// The same for people: fewer columns, rounded; no stresses without full fields.
Table critical_speed_summary(const Study& study);
/// What the linear rules list, and whether a critical speed was there: linear_criterion.csv. Forward waves that eq. 2
/// leaves out stand in it as excluded.
Table linear_criterion_record(const Study& study);
/// One row a speed, failed ones included: how steady, how exact, how much contact; speeds.csv.
Table speed_record(const Study& study);

/// Every speed from rest, swept up and swept down: sweeps.csv. Needs sweeps.
Table sweep_record(const Study& study);
/// The line through the places that both edges rub: contact_drift.csv.
Table drift_record(const Study& study);

/// Whether the stress at a critical speed is known: it takes full fields and a response that holds the rotor's state.
bool has_stress(const Study& study);

/// "periodic", "subharmonic 1/3", "irregular".
std::string motion_text(MotionClass motion, int period_revolutions);

}  // namespace tiprub
