// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/response.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tiprub {

double largest_excursion(const Eigen::MatrixXd& displacement) {
  const Eigen::MatrixXd squares = (displacement.rowwise() - displacement.colwise().mean()).cwiseAbs2();
  double largest = 0;
  for (Eigen::Index node = 0; 3 * node + 2 < squares.cols(); ++node)
    largest = std::max(largest, squares.middleCols(3 * node, 3).rowwise().sum().maxCoeff());
  return std::sqrt(largest);
}

BladeExcursions blade_excursions(const Eigen::MatrixXd& displacement, int sectors) {
  const Eigen::Index dofs = displacement.cols() / sectors;
  std::vector<double> blades;
  for (int j = 0; j < sectors; ++j) blades.push_back(largest_excursion(displacement.middleCols(j * dofs, dofs)));
  std::ranges::sort(blades);
  const std::size_t half = blades.size() / 2;
  return {blades.front(), (blades[half] + blades[blades.size() - 1 - half]) / 2, blades.back()};
}

}  // namespace tiprub
