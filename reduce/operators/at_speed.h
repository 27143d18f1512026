// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include "cases/program/errors.h"
#include "cases/program/units.h"

namespace tiprub {

/// "at 9000 rpm", of a speed in rad/s.
inline std::string name_of_speed(double speed) {
  return "at " + std::to_string(std::lround(speed * rpm_per_rad_s)) + " rpm";
}

/// Does what is to be done at a speed [rad/s]; a RunError then says at which.
template <class Body>
auto at_speed(double speed, const Body& body) {
  try {
    return body();
  } catch (const RunError& error) {
    throw RunError(name_of_speed(speed) + ": " + error.what());
  }
}

}  // namespace tiprub
