// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <string>

namespace tiprub {

// What people read: rpm, Hz, mm, MPa. The files hold SI.
inline constexpr double mm_per_m = 1e3;
inline constexpr double rpm_per_rad_s = 30.0 / std::numbers::pi;
inline constexpr double hz_per_rad_s = 0.5 / std::numbers::pi;
inline constexpr double mpa_per_pa = 1e-6;

/// "12300 rpm" for a speed in rad/s.
std::string rpm_text(double speed);

}  // namespace tiprub
