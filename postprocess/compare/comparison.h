// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/compare/other_report.h"
#include "postprocess/fields/field_results.h"
#include "postprocess/figures/figure.h"

namespace tiprub {

/// Critical speeds side by side with their shifts, from there to here, ascending in speed; what is no more
/// than the tables' last digits is 0. Two belong together if the
/// same wave makes them (engine order, signed nodal diameter and family), the nearest if there are several; the
/// others stand alone.
Table comparison_record(const Study& study, const FieldResults& fields, const OtherReport& other);

/// The interaction maps of both, of the edge asked for, side by side.
Figure comparison_map_figure(const Study& study, const OtherReport& other);

/// Both responses over speed.
Figure comparison_figure(const Study& study, const OtherReport& other);

}  // namespace tiprub
