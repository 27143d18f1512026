// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response.h"

#include <cmath>

namespace tiprub {

double largest_excursion(const Eigen::MatrixXd& displacement) {
  const Eigen::MatrixXd squares = (displacement.rowwise() - displacement.colwise().mean()).cwiseAbs2();
  double largest = 0;
  for (Eigen::Index node = 0; 3 * node + 2 < squares.cols(); ++node)
    largest = std::max(largest, squares.middleCols(3 * node, 3).rowwise().sum().maxCoeff());
  return std::sqrt(largest);
}

}  // namespace tiprub
