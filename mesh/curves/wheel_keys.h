// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "cases/program/case_file.h"
#include "mesh/curves/smooth_table.h"

namespace tiprub::mesh {

/// [m] The lengths of a wheel. A length beyond ten metres was meant in millimetres.
inline const Range wheel_length{0.0, 10.0, Range::LowEnd::excluded};

/// A curve over the chord, [[fraction, value], ...] with fractions from 0 to 1, or one point for a constant. Values
/// are multiplied by the factor (degrees to radians).
SmoothTable read_chord_table(CaseTable& table, std::string_view key,
                             std::optional<std::vector<std::array<double, 2>>> fallback, const Range& range,
                             std::string_view unit, double factor = 1.0);

/// [m] of one unit of the key `length_unit`: m, cm, mm or in.
double read_length_unit(CaseTable& table);

}  // namespace tiprub::mesh
