// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/compare/report_numbers.h"
#include "postprocess/figures/drawing.h"

namespace tiprub::postprocess {

/// In one sentence, what differs; then what is to be kept in mind: the keys that differ, and other grids of speeds.
std::string comparison_in_words(const ReportNumbers& here, const ReportNumbers& other);

/// Critical speeds of both reports side by side, ascending in speed, with the shifts from the other report to this
/// one; a shift within rounding is 0. Two critical speeds are paired if the same wave makes them (engine order,
/// signed nodal diameter and family); of several candidates, the nearest are paired. Each unpaired one has its own
/// row.
Table comparison_record(const ReportNumbers& this_one, const ReportNumbers& other);

/// The same for each of the others, one after the other; of several, the first column names the report.
Table comparison_record(const ReportNumbers& this_one, const std::vector<ReportNumbers>& others);

/// A row for this report and for each other one: the keys of its case that differ, its largest critical speed, and
/// the speeds to avoid.
Table reports_record(const ReportNumbers& this_one, const std::vector<ReportNumbers>& others);

/// The interaction maps of both reports side by side, for the edge asked for.
Figure comparison_map_figure(const Study& study, const ReportNumbers& this_one, const ReportNumbers& other);

/// The responses of all reports over speed.
Figure comparison_figure(const ReportNumbers& this_one, const std::vector<ReportNumbers>& others);

}  // namespace tiprub::postprocess
