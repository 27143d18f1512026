// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response.h"

#include <cmath>

#include "simulate/response/speed_numbers.h"

namespace tiprub {

const char* name_of(MotionClass motion) {
  return name_in(motion_names, motion);
}

const char* name_of(MotionMeasure measure) {
  return name_in(measure_names, measure);
}

const char* name_of(Start start) {
  return name_in(start_names, start);
}

const char* name_of(Variation variation) {
  return name_in(variation_names, variation);
}

double largest_excursion(const Eigen::MatrixXd& displacement) {
  const Eigen::MatrixXd squares = (displacement.rowwise() - displacement.colwise().mean()).cwiseAbs2();
  double largest = 0;
  for (Eigen::Index node = 0; 3 * node + 2 < squares.cols(); ++node)
    largest = std::max(largest, squares.middleCols(3 * node, 3).rowwise().sum().maxCoeff());
  return std::sqrt(largest);
}

}  // namespace tiprub
