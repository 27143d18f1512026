// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/compare/comparison.h"
#include "postprocess/fields/field_study.h"

namespace tiprub::postprocess {

/// The data of the page's linked views, packed by PackedArrays. For every speed, for the contact nodes of both
/// edges and for the sectors that the response holds: motion (the component asked for, and the normal and
/// tangential ones for the orbit) [mm], contact force [N], two-way spectrum up to the highest engine order that is
/// drawn [mm], and the column of the contact map [1], the largest stress [MPa] that stress_over_speed()
/// estimates, and utilisation_over_speed(). Further, the speeds to avoid [rpm], the natural frequencies [Hz] of the
/// drawn families and, with other reports, their responses and maps. The page adds the two directions of a nodal
/// diameter and computes nothing else.
std::string speed_data(const Study& study, const FieldResults& fields, const std::vector<ReportNumbers>& others);

/// The data from which the page draws the wheel, packed by PackedArrays: the surface of a sector, the natural
/// modes, the contact line and the casing's shape and, for every critical speed with a cycle, its waves, the
/// largest stress over the cycle at each node [MPa], and the contact forces [N]. If the surface has too many nodes
/// for a page, the nodes between the corners of its faces are left out.
std::string wheel_data(const Response& response, const ContactLine& contact, const FieldStudy& fields);

}  // namespace tiprub::postprocess
