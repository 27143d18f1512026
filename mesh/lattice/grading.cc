// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/lattice/grading.h"

#include <algorithm>
#include <cmath>

namespace tiprub {

double graded(int half_index, int count, double ratio) {
  const double growth = std::pow(ratio, 1.0 / std::max(1, (count - 1) / 2));
  double all = 0.0, before = 0.0;
  for (int element = 0; element < count; ++element) {
    const double size = std::pow(growth, std::min(element, count - 1 - element));
    all += size;
    before += size * std::clamp(0.5 * half_index - element, 0.0, 1.0);
  }
  return 2.0 * count * before / all;
}

}  // namespace tiprub
