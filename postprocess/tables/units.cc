// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/tables/units.h"

#include "postprocess/tables/table.h"

namespace tiprub {

std::string rpm_text(double speed) {
  return fixed(speed * rpm_per_rad_s, 0) + " rpm";
}

std::string mpa_text(double stress) {
  return fixed(stress * mpa_per_pa, 0) + " MPa";
}

}  // namespace tiprub
