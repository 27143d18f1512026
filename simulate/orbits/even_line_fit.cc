// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/even_line_fit.h"

#include <cstddef>

namespace tiprub {

double slope_per_place(const std::vector<double>& values) {
  const double middle = (static_cast<double>(values.size()) - 1) / 2;
  double moment = 0, spread = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double offset = static_cast<double>(i) - middle;
    moment += offset * values[i];
    spread += offset * offset;
  }
  return spread > 0 ? moment / spread : 0.0;
}

}  // namespace tiprub
