// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/peaks.h"

#include <gtest/gtest.h>

namespace tiprub::simulate {
namespace {

TEST(ParabolaTop, IsExactOnAParabola) {
  const auto curve = [](double x) { return 5 - 3 * (x - 1.7) * (x - 1.7); };
  const ParabolaTop top = parabola_top({1.0, 1.6, 2.6}, {curve(1.0), curve(1.6), curve(2.6)});
  EXPECT_NEAR(top.offset, 0.1, 1e-12);
  EXPECT_NEAR(top.height, 0.03, 1e-12);
}

Eigen::VectorXd curve_of(std::initializer_list<double> values) {
  return Eigen::VectorXd::Map(values.begin(), static_cast<Eigen::Index>(values.size()));
}

/// A tent with its top at 3, between the samples at 2.5 and 4; a jump behind and before the sample at 1; the end of a
/// curve.
TEST(RiseBeside, IsWhereTheFlanksMeet) {
  const Eigen::VectorXd places = curve_of({0, 1, 2.5, 4, 5}), tent = curve_of({2, 3, 4.5, 3, 1});
  EXPECT_NEAR(rise_beside(places, tent, 2, +1), 0.5, 1e-12);
  EXPECT_NEAR(rise_beside(curve_of({0, 1, 2, 3}), curve_of({0.9, 1, 0.2, 0.1}), 1, +1), 0.1, 1e-12);
  EXPECT_NEAR(rise_beside(curve_of({0, 1, 2, 3}), curve_of({0.1, 1, 0.98, 0.97}), 1, +1), 0.02, 1e-12);
  EXPECT_NEAR(rise_beside(curve_of({0, 1, 3}), curve_of({0, 1, 0.5}), 1, +1), 2.0, 1e-12);
}

std::vector<Eigen::Index> named(const Eigen::VectorXd& curve) {
  std::vector<Eigen::Index> places;
  for (const Peak& peak : named_peaks(curve, {.prominence = 0.25})) places.push_back(peak.index);
  return places;
}

/// Symptom: a critical speed of 85 % of the worst amplitude was in no table, because the valley to its neighbour was
/// shallow.
TEST(NamedPeaks, HaveAllThatAreNearlyAsSevereAsTheWorst) {
  EXPECT_EQ(named(curve_of({0.1, 0.85, 0.8, 1, 0.1})), (std::vector<Eigen::Index>{1, 3}));
  EXPECT_EQ(named(curve_of({0.1, 0.75, 0.7, 1, 0.1})), (std::vector<Eigen::Index>{3}));
  EXPECT_EQ(named(curve_of({0.1, 0.3, 0.2, 1, 0.1})), (std::vector<Eigen::Index>{1, 3}));
}

TEST(NamedPeaks, HaveARaggedTopOnce) {
  EXPECT_EQ(named(curve_of({0.1, 0.99, 0.98, 1, 0.985, 0.99, 0.1})), (std::vector<Eigen::Index>{3}));
}

}  // namespace
}  // namespace tiprub::simulate
