// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace tiprub {

// What people read: rpm, Hz, mm. The files hold SI.
inline constexpr double mm_per_m = 1e3;
inline constexpr double rpm_per_rad_s = 30.0 / std::numbers::pi;
inline constexpr double hz_per_rad_s = 0.5 / std::numbers::pi;

}  // namespace tiprub
