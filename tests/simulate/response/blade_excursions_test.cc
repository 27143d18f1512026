// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "simulate/response/response.h"

namespace tiprub {
namespace {

/// Blades of one contact node, whose paths have different radii and middles.
TEST(BladeExcursions, AreThoseOfEachBlade) {
  const std::vector<double> radii = {4e-3, 1e-3, 2e-3, 3e-3};
  constexpr int samples = 12;
  Eigen::MatrixXd displacement = Eigen::MatrixXd::Constant(samples, 12, 0.1);
  for (int s = 0; s < samples; ++s)
    for (std::size_t j = 0; j < radii.size(); ++j) {
      const double turn = 2 * std::numbers::pi * s / samples;
      displacement.block<1, 2>(s, 3 * static_cast<int>(j)) += radii[j] * Eigen::RowVector2d(cos(turn), sin(turn));
    }
  const BladeExcursions four = blade_excursions(displacement, 4),
                        three = blade_excursions(displacement.leftCols(9), 3);
  constexpr double rounding = 1e-12;
  EXPECT_NEAR(four.least, 1e-3, rounding);
  EXPECT_NEAR(four.median, 2.5e-3, rounding);
  EXPECT_NEAR(four.largest, 4e-3, rounding);
  EXPECT_NEAR(three.median, 2e-3, rounding);
  EXPECT_NEAR(largest_excursion(displacement), four.largest, rounding);
}

}  // namespace
}  // namespace tiprub
