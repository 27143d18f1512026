// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/scheme_agreement.h"

#include <gtest/gtest.h>

#include <iostream>

namespace tiprub::simulate::testing {
namespace {

/// The default and central differences share the modes, the loop and the law of contact, but no coefficient: speeds
/// of the made-up wheel of 900 dofs against two lobes.
void expect_agreement(double friction, int count) {
  BenchWheel wheel = made_wheel(2);
  wheel.casing.friction = {{0.0, friction}};
  const std::vector<SchemePair> pairs = compare_schemes(wheel, 600, 1400, count);
  ASSERT_EQ(pairs.size(), static_cast<std::size_t>(count));
  int agreeing = 0;
  for (const SchemePair& at : pairs) {
    EXPECT_EQ(at.trigonometric.failure + at.central.failure, "");
    EXPECT_GT(at.trigonometric.contact_steps, 0) << at.speed;
    EXPECT_EQ(at.trigonometric.tension_steps + at.central.tension_steps, 0) << at.speed;
    EXPECT_EQ(at.trigonometric.leftover_steps + at.central.leftover_steps, 0) << at.speed;
    if (at.agree())
      ++agreeing;
    else
      std::cout << at.speed << " rad/s: " << class_of(at.trigonometric) << " and " << class_of(at.central)
                << ", amplitude differs by " << at.amplitude_difference << ", contact maps overlap by "
                << at.pattern_overlap << "\n";
  }
  EXPECT_GE(agreeing, 0.95 * count);
}

TEST(Schemes, AgreeOnAmplitudeAndContactPattern) {
  expect_agreement(0, 40);
}

TEST(Schemes, AgreeWithFriction) {
  expect_agreement(0.1, 24);
}

}  // namespace
}  // namespace tiprub::simulate::testing
