// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/compare/report_numbers.h"
#include "postprocess/figures/figure.h"

namespace tiprub {

/// Critical speeds side by side with their shifts, from there to here, ascending in speed; a shift that is no
/// more than rounding is 0. Two belong together if the same wave makes them (engine order, signed nodal diameter and
/// family), the nearest if there are several; the others stand alone.
Table comparison_record(const ReportNumbers& this_one, const ReportNumbers& other);

/// The interaction maps of both, of the edge asked for, side by side.
Figure comparison_map_figure(const Study& study, const ReportNumbers& this_one, const ReportNumbers& other);

/// Both responses over speed.
Figure comparison_figure(const ReportNumbers& this_one, const ReportNumbers& other);

}  // namespace tiprub
