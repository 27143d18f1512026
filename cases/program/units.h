// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace tiprub {

// People read and write rpm, Hz, mm and MPa; the files hold SI units.
inline constexpr double rad_s_per_rpm = std::numbers::pi / 30.0;
inline constexpr double rpm_per_rad_s = 30.0 / std::numbers::pi;
inline constexpr double hz_per_rad_s = 0.5 / std::numbers::pi;
inline constexpr double radians_per_degree = std::numbers::pi / 180.0;
inline constexpr double mm_per_m = 1e3;
inline constexpr double mpa_per_pa = 1e-6;

}  // namespace tiprub
