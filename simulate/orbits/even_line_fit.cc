// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/even_line_fit.h"

#include <cmath>
#include <cstddef>

namespace tiprub {

EvenLine fit_even_line(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double middle = (count - 1) / 2;
  double moment = 0, spread = 0, mean = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double offset = static_cast<double>(i) - middle;
    moment += offset * values[i];
    spread += offset * offset;
    mean += values[i] / count;
  }
  if (spread == 0) return {};
  EvenLine line{moment / spread, 0};
  if (count < 3) return line;
  double residual = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double offset = static_cast<double>(i) - middle;
    residual += std::pow(values[i] - mean - line.slope * offset, 2);
  }
  line.uncertainty = std::sqrt(residual / (count - 2) / spread);
  return line;
}

}  // namespace tiprub
