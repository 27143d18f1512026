// SPDX-License-Identifier: GPL-3.0-or-later
// The linear rules: eq. 2, and with aliasing eq. 16 and eq. 17. Checks 10-11.
#include "postprocess/analysis/linear_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "synthetic_scene.h"

namespace tiprub::postprocess::linear_criterion_test {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// eq. 2 at f_c = 0.
TEST(LinearCriterion, Equation2MatchesTheClosedForm) {
  const FrequencyCurves curves(synthetic::frequencies(synthetic::model()));
  const SpeedRange range{1000, 2500};
  const std::vector<Crossing> crossings = equation_2_crossings(curves, 10, {0, 1}, range);
  std::size_t expected = 0;
  for (int n = 1; n <= 5; ++n)
    for (int family = 0; family < 2; ++family) {
      const double speed = synthetic::crossing_speed(n, family, n);
      if (speed < range.low || speed > range.high) continue;
      ++expected;
      EXPECT_TRUE(std::any_of(crossings.begin(), crossings.end(),
                              [&](const Crossing& crossing) {
                                return crossing.signed_nodal_diameter == n && crossing.engine_order == n &&
                                       crossing.family == family && std::abs(crossing.speed - speed) < 1e-8 * speed;
                              }))
          << "nodal diameter " << n << ", family " << family;
    }
  EXPECT_GT(expected, 0U);
  EXPECT_EQ(crossings.size(), expected);
}

/// eq. 16: every engine order is a multiple of N_l = 2.
TEST(LinearCriterion, AliasedCrossingsMatchTheClosedForm) {
  const FrequencyCurves curves(synthetic::frequencies(synthetic::model()));
  for (const Crossing& crossing :
       aliased_crossings(curves, 10, {0, 1}, 2, {1, 2, 3, 4, 5, 6, 7, 8, 10, 12}, {1000, 2500})) {
    EXPECT_EQ(crossing.engine_order % 2, 0);
    EXPECT_EQ(crossing.signed_nodal_diameter, signed_nodal_diameter(crossing.engine_order, 10));
    const double speed =
        synthetic::crossing_speed(std::abs(crossing.signed_nodal_diameter), crossing.family, crossing.engine_order);
    EXPECT_NEAR(crossing.speed, speed, 1e-8 * speed);
  }
  EXPECT_TRUE(aliased_crossings(curves, 10, {0, 1}, 0, {2, 4}, {1000, 2500}).empty());
}

/// What eq. 2 leaves of eq. 1: f = |-f_c + n Omega| has two roots, n Omega = f_c - f and f_c + f, for a mode below
/// the casing's.
TEST(LinearCriterion, AFlexibleCasingGivesBothRoots) {
  const auto constant = [](double) { return 100.0; };
  const std::vector<double> speeds = criterion_speeds(constant, 4, 300.0, {0, 1000});
  ASSERT_EQ(speeds.size(), 2U);
  EXPECT_NEAR(speeds[0], two_pi * 200 / 4, 1e-9);
  EXPECT_NEAR(speeds[1], two_pi * 400 / 4, 1e-9);
}

TEST(FrequencyCurves, FollowTheClosedFormBetweenTheirSamples) {
  const FrequencyCurves curves(synthetic::frequencies(synthetic::model(9)));
  EXPECT_EQ(curves.nodal_diameters(), 5);
  for (const double speed : {0.0, 37.0, 911.0, 1777.7, 2500.0})
    for (int n = 0; n < 5; ++n)
      for (int family = 0; family < 3; ++family)
        EXPECT_NEAR(curves.frequency(n, family, speed), synthetic::frequency(n, family, speed), 1e-7);
}

}  // namespace
}  // namespace tiprub::postprocess::linear_criterion_test
