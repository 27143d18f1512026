// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/peaks.h"

#include <gtest/gtest.h>

namespace tiprub {
namespace {

TEST(ParabolaTop, IsExactOnAParabola) {
  const auto curve = [](double x) { return 5 - 3 * (x - 1.7) * (x - 1.7); };
  const ParabolaTop top = parabola_top({1.0, 1.6, 2.6}, {curve(1.0), curve(1.6), curve(2.6)});
  EXPECT_NEAR(top.offset, 0.1, 1e-12);
  EXPECT_NEAR(top.height, 0.03, 1e-12);
}

}  // namespace
}  // namespace tiprub
