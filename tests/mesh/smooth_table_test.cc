// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/curves/smooth_table.h"

#include <gtest/gtest.h>

namespace tiprub::mesh {
namespace {

TEST(SmoothTable, GoesThroughItsPoints) {
  const SmoothTable table({{0.0, 1.0}, {0.3, 4.0}, {1.0, 2.0}});
  EXPECT_DOUBLE_EQ(table.at(0.0), 1.0);
  EXPECT_DOUBLE_EQ(table.at(0.3), 4.0);
  EXPECT_DOUBLE_EQ(table.at(1.0), 2.0);
}

TEST(SmoothTable, NeverOvershoots) {
  const SmoothTable table({{0.0, 1.0}, {0.3, 4.0}, {1.0, 2.0}});
  for (int i = 0; i <= 100; ++i) {
    const double x = 0.01 * i;
    EXPECT_GE(table.at(x), 1.0);
    EXPECT_LE(table.at(x), 4.0);
  }
}

TEST(SmoothTable, ReproducesAStraightLineAndAConstant) {
  const SmoothTable line({{0.0, 1.0}, {0.2, 1.4}, {1.0, 3.0}});
  for (int i = 0; i <= 20; ++i) EXPECT_NEAR(line.at(0.05 * i), 1.0 + 0.1 * i, 1e-14);
  EXPECT_DOUBLE_EQ(SmoothTable({{0.0, 7.0}}).at(0.4), 7.0);
}

TEST(SmoothTable, HasNoKinkAtItsPoints) {
  const SmoothTable table({{0.0, 0.0}, {0.4, 1.0}, {1.0, 5.0}});
  const double h = 1e-6;
  const double left = (table.at(0.4) - table.at(0.4 - h)) / h;
  const double right = (table.at(0.4 + h) - table.at(0.4)) / h;
  EXPECT_NEAR(left, right, 1e-4);
}

}  // namespace
}  // namespace tiprub::mesh
