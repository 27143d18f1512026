// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

/// The critical speeds with every digit and unit, for critical_speeds.csv. Stresses are empty without full fields.
Table critical_speed_record(const Study& study, const FieldResults& fields);
/// A rounded table as wide as a terminal; without stresses if there are no full fields.
Table critical_speed_overview(const Study& study, const FieldResults& fields);
/// Its two halves for the page, which is not wide enough for both side by side: the motion, and the stress.
Table critical_speed_motions(const Study& study);
Table critical_speed_stresses(const Study& study, const FieldResults& fields);

/// motion_text() of a speed. A motion of equal sectors that is not stable on the whole wheel is "symmetric, unstable
/// (periodic)"; where that is open, "symmetric, stability open (periodic)".
std::string motion_text(const SpeedResponse& speed);
/// The motion from rest with all nodal diameters, which is what would be seen; null unless the speed was examined and
/// symmetry does not clearly hold there.
const OtherStart* whole_wheel(const SpeedResponse& speed);
/// "modulated, |u| 2.91 / 3.30 / 4.12": that motion, and [mm] the least, median and largest motion of its blades'
/// tips.
std::string whole_wheel_text(const SpeedResponse& speed);

/// One row a speed, failed ones included: stress, how steady, how exact, how much contact; speeds.csv.
Table speed_record(const Study& study, const FieldResults& fields);

/// Every speed from rest, swept up and swept down: sweeps.csv. Needs sweeps.
Table sweep_record(const std::vector<SpeedResponse>& speeds, const TipAmplitudes& amplitudes,
                   const std::vector<SweepComparison>& sweeps);

/// Every orbit of every branch, in the order along the branch: branches.csv. Needs branches.
Table branch_record(const std::vector<OrbitBranch>& branches);

/// How the contact moves with speed: the lines through the middles of both edges' contact, and the lag of the leading
/// edge's force; contact_drift.csv.
Table drift_record(const ContactMaps& maps, const ContactLine& contact);

/// What the linear rules list (eq. 2; eq. 17 with aliasing), and whether a critical speed was there:
/// linear_criterion.csv. Forward waves, which eq. 2 leaves out, are listed as excluded.
Table linear_criterion_record(const Study& study);
/// How well each rule predicted the critical speeds: linear_rules.csv.
Table rule_score_record(const LinearRules& rules);

/// The largest stress at every speed whose fields were recovered, and its place in full; stress_peaks.csv.
Table stress_peak_record(const FieldStudy& fields);
/// The frequency of every natural mode that was examined, and each part's share in it; modes.csv.
Table mode_record(const FieldStudy& fields);

/// What the motion at a speed of the response leaves of the range in which its model holds, with the numbers; empty
/// if it stays inside. `stress`: there, if it is known.
std::string outside_validity(const Study& study, Eigen::Index index, const std::optional<FieldPeak>& stress);

/// "inside", "outside: 0.12 / 0.037 mm" (the gap's terms of second order and the interference), "outside: yield".
std::string validity_in_short(const Study& study, std::size_t critical, const FieldResults& fields);

}  // namespace tiprub::postprocess
