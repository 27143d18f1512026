// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/sector_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/sector/sector_check.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/mesh/sector_geometry.h"

namespace tiprub::mesh {
namespace {

std::vector<double> sizes(int count, double ratio) {
  std::vector<double> sizes;
  for (int element = 0; element < count; ++element)
    sizes.push_back(0.5 * (graded(2 * element + 2, count, ratio) - graded(2 * element, count, ratio)));
  return sizes;
}

TEST(Grading, ElementsThatAreAlikeStayWhereTheyAreToTheLastBit) {
  for (const int count : {1, 2, 7, 12, 400})
    for (int half = 0; half <= 2 * count; ++half) EXPECT_EQ(graded(half, count, 1.0), half);
}

TEST(Grading, ElementsGrowByOneFactorFromBothEndsToTheMiddle) {
  for (const int count : {3, 4, 9, 14}) {
    const int steps = (count - 1) / 2;  // from the smallest to the largest
    const std::vector<double> size = sizes(count, 5.0);
    EXPECT_NEAR(*std::max_element(size.begin(), size.end()) / size.front(), 5.0, 1e-12);
    EXPECT_NEAR(graded(2 * count, count, 5.0), 2.0 * count, 1e-12);
    for (int element = 0; element < count; ++element) EXPECT_NEAR(size[element], size[count - 1 - element], 1e-12);
    for (int element = 1; 2 * element < count - 1; ++element)
      EXPECT_NEAR(size[element] / size[element - 1], std::pow(5.0, 1.0 / steps), 1e-12);
  }
}

TEST(Grading, MidSideNodesStayInTheMiddle) {
  for (int half = 1; half < 14; half += 2)
    EXPECT_NEAR(graded(half, 7, 3.0), 0.5 * (graded(half - 1, 7, 3.0) + graded(half + 1, 7, 3.0)), 1e-12);
}

TEST(Grading, OneOrTwoElementsAreAlike) {
  EXPECT_EQ(sizes(1, 9.0), std::vector<double>({1.0}));
  EXPECT_EQ(sizes(2, 9.0), std::vector<double>({1.0, 1.0}));
}

TEST(Grading, OfAWheelKeepsItsShapeAndTheSplittersEdgeBetweenTwoElements) {
  const std::string even = test::case_text("fast_impeller");
  const Wheel same = test::wheel_from(even);
  const Wheel wheel =
      test::wheel_from(test::with_keys(even, "grading_along_chord = 4.0\ngrading_along_span = 3.0\n"));
  const SectorPlan& plan = wheel.plan;
  EXPECT_DOUBLE_EQ(plan.station(2 * plan.elements.upstream), 0.45);
  EXPECT_NEAR(plan.station(1), plan.station(2) / 2.0, 1e-15);
  EXPECT_LT(plan.station(2), 0.6 * same.plan.station(2));  // finer at the leading edge, trailing edge, root and tip
  EXPECT_LT(1.0 - plan.station(2 * plan.elements.chord - 2),
            0.6 * (1.0 - same.plan.station(2 * plan.elements.chord - 2)));
  EXPECT_NEAR(plan.span(2, 0.0), 1.0 - plan.span(2 * plan.elements.span - 2, 0.0), 1e-15);
  EXPECT_LT(plan.span(2, 0.0), same.plan.span(2, 0.0));
  const SectorReport report = measure_sector(mesh_sector(wheel), wheel);
  EXPECT_GT(report.worst_scaled_jacobian, 0.25);
  EXPECT_NEAR(report.mesh_volume / test::geometry_volume(wheel), 1.0, 2e-4);  // those in the middle are larger
  EXPECT_NEAR(test::geometry_volume(wheel) / test::geometry_volume(same), 1.0, 5e-7);  // tables bend between stations
}

}  // namespace
}  // namespace tiprub::mesh
