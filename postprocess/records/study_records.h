// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// One row a speed, failed ones included: how steady, how exact, how much contact; speeds.csv.
Table speed_record(const Study& study);

/// Every speed from rest, swept up and swept down: sweeps.csv. Needs sweeps.
Table sweep_record(const std::vector<SpeedResponse>& speeds, const TipAmplitudes& amplitudes,
                   const std::vector<SweepComparison>& sweeps);

/// Every orbit of every branch, in the order in which they hang together: branches.csv. Needs branches.
Table branch_record(const std::vector<OrbitBranch>& branches);

/// How the contact moves with speed: the lines through the middles of both edges' contact, and how late the leading
/// edge's force comes; contact_drift.csv.
Table drift_record(const ContactMaps& maps, const ContactLine& contact);

/// What the linear rules list (eq. 2; eq. 17 with aliasing), and whether a critical speed was there:
/// linear_criterion.csv. Forward waves that eq. 2 leaves out stand in it as excluded.
Table linear_criterion_record(const Study& study);
/// What each rule was worth, counted and by amplitude: linear_rules.csv.
Table rule_score_record(const LinearRules& rules);

/// The largest stress at every speed whose fields were recovered, and its place in full; stress_peaks.csv.
Table stress_peak_record(const FieldStudy& fields);
/// The frequency of every natural mode that was looked at, and how much each part of the wheel takes part in it;
/// modes.csv.
Table mode_record(const FieldStudy& fields);

}  // namespace tiprub
