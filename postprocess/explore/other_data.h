// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "postprocess/compare/other_report.h"
#include "postprocess/explore/packed_arrays.h"

namespace tiprub {

/// What the page lays beside its own views: the other report's response [mm] and interaction maps [mm], by the speeds
/// and spectral lines of its tables.
nlohmann::json add_other(PackedArrays& arrays, const OtherReport& other);

}  // namespace tiprub
