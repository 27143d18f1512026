// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/program/units.h"

namespace tiprub {

/// "12300 rpm" for a speed in rad/s.
std::string rpm_text(double speed);

}  // namespace tiprub
