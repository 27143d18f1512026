// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/program/units.h"

namespace tiprub {

inline constexpr double percent = 100.0;

/// "12300 rpm" for a speed in rad/s.
std::string rpm_text(double speed);
/// "583 MPa" for a stress in Pa.
std::string mpa_text(double stress);

}  // namespace tiprub
