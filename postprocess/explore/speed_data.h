// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "postprocess/analysis/study.h"
#include "postprocess/compare/report_numbers.h"

namespace tiprub {

/// What the page's linked views draw, of every speed of a study, packed as PackedArrays does. Of the two edges'
/// contact nodes only, and of the sectors that the response holds: motion (the component asked for, and the normal
/// and the tangential one for the orbit) [mm], contact force [N], two-way spectrum up to the highest engine order
/// drawn [mm], the line of the contact map [1]; and natural frequencies [Hz] of the drawn families. The page computes
/// nothing of these but sums over both directions of a nodal diameter, which the maps' tables hold as well.
/// With another report, that one's response and maps too.
std::string speed_data(const Study& study, const std::optional<ReportNumbers>& other);

}  // namespace tiprub
