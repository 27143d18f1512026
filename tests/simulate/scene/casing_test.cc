// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/casing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::casing_test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Casing, HasItsCrestsInward) {
  Casing casing = testing::lobed_casing(3, 2e-4, 1e-3);
  casing.crest_angle = 0.2;
  for (int lobe = -3; lobe < 4; ++lobe) {
    EXPECT_NEAR(casing.distortion(0.2 + lobe * 2 * pi / 3, 0), 2e-4, 1e-18);
    EXPECT_NEAR(casing.distortion(0.2 + pi / 3 + lobe * 2 * pi / 3, 0), -2e-4, 1e-18);
  }
}

/// eq. 16: what a blade meets as it turns is periodic with f = N_l Omega, and with no lower frequency.
TEST(Casing, MeetsABladeWithTheFrequencyOfItsLobes) {
  const int lobes = 3, samples = 360;
  const Casing casing = testing::lobed_casing(lobes, 2e-4, 1e-3);
  for (int order = 0; order <= 2 * lobes; ++order) {
    std::complex<double> amplitude = 0;
    for (int s = 0; s < samples; ++s)
      amplitude +=
          casing.distortion(2 * pi * s / samples, 0) * std::polar(2.0 / samples, -2 * pi * order * s / samples);
    EXPECT_NEAR(std::abs(amplitude), order == lobes ? 2e-4 : 0.0, 1e-17) << "engine order " << order;
  }
}

TEST(Casing, IsRoundBetweenItsBumps) {
  Casing casing = testing::lobed_casing(2, 1e-4, 1e-3);
  casing.shape = CasingShape::bumps;
  casing.bump_width = 0.4;
  EXPECT_NEAR(casing.distortion(pi, 0), 1e-4, 1e-18);
  EXPECT_NEAR(casing.distortion(0.1, 0), 0.5e-4, 1e-18);
  EXPECT_EQ(casing.distortion(0.2, 0), 0.0);
  EXPECT_EQ(casing.distortion(1.5, 0), 0.0);
}

/// A bump so narrow that the response's half degrees miss its crest, and a table whose largest value is outward.
TEST(Casing, KnowsItsCrestsInward) {
  const ReducedModel model = testing::synthetic_wheel({});
  Casing casing = testing::lobed_casing(2, 1e-4, 1e-3);
  casing.shape = CasingShape::bumps;
  casing.crest_angle = 0.25 * pi / 180;
  casing.bump_width = pi / 180;
  EXPECT_EQ(casing.crests(model.contact).size(), model.contact.size());
  EXPECT_NEAR(casing.crests(model.contact).minCoeff(), 1e-4, 1e-18);
  casing.shape = CasingShape::table;
  casing.amplitude = 5e-4;
  casing.table = PeriodicTable({{0.0, 0.5e-4}, {pi / 2, -5e-4}}, pi);
  EXPECT_NEAR(casing.crests(model.contact).maxCoeff(), 0.5e-4, 1e-7);
}

TEST(Casing, GrowsSmoothly) {
  Casing casing = testing::lobed_casing(2, 1e-4, 1e-3);
  casing.ramp_revolutions = 4;
  EXPECT_EQ(casing.ramp(0), 0.0);
  EXPECT_EQ(casing.ramp(2), 0.5);
  EXPECT_EQ(casing.ramp(4), 1.0);
  EXPECT_EQ(casing.ramp(1000), 1.0);
  EXPECT_LT(casing.ramp(0.004), 1e-8);  // with level tangent and no curvature at its ends
}

TEST(Casing, ClosesAColdClearanceBySpin) {
  const ReducedModel model = testing::synthetic_wheel({});
  Casing casing = testing::lobed_casing(2, 1e-4, 1e-3);
  casing.clearance = {{0.0, 1e-3}, {0.5, 5e-4}, {1.0, 6e-4}};
  const double speed = 1000;
  const Eigen::VectorXd given = casing.given_clearance(model.contact);
  EXPECT_NEAR((given - Eigen::Vector3d(1e-3, 5e-4, 6e-4)).norm(), 0, 1e-18);
  EXPECT_EQ(casing.running_clearance(model.contact, speed), given);
  casing.clearance_state = ClearanceState::cold;
  const Eigen::VectorXd left = casing.running_clearance(model.contact, speed);
  for (int k = 0; k < 3; ++k) {
    const double shift = model.contact.normal(k, 0) * 1e-5 + model.contact.normal(k, 2) * 2e-5;
    EXPECT_NEAR(left[k], given[k] - shift, 1e-18);
  }
}

TEST(Casing, KeepsTheClearanceThatWasGivenAtOneSpeed) {
  const ReducedModel model = testing::synthetic_wheel({});
  Casing casing = testing::lobed_casing(2, 1e-4, 1e-3);
  const double speed = 1000, slower = 600;
  casing.clearance_state = ClearanceState::cold;
  const Eigen::VectorXd cold = casing.given_clearance(model.contact);
  const Eigen::VectorXd at_speed = casing.running_clearance(model.contact, speed);
  const Eigen::VectorXd at_slower = casing.running_clearance(model.contact, slower);
  const Eigen::VectorXd opened = at_slower - at_speed;
  ASSERT_GT(opened.norm(), 1e-6);
  casing.clearance_state = ClearanceState::at_speed;
  casing.clearance_speed = speed;
  EXPECT_EQ(casing.running_clearance(model.contact, speed), cold);  // what is given
  EXPECT_LT((casing.running_clearance(model.contact, slower) - cold - opened).norm(), 1e-18);
}

TEST(PeriodicTable, GoesThroughItsPointsAndStaysBetweenThem) {
  const std::vector<std::array<double, 2>> points = {{0.1, 0.0}, {0.5, 1.0}, {0.9, 1.0}, {1.5, -2.0}};
  const PeriodicTable table(points, 2.0);
  for (const auto& [x, y] : points)
    for (double turns : {-3.0, 0.0, 5.0}) EXPECT_NEAR(table(x + 2 * turns), y, 1e-12);
  for (int i = 0; i < 40; ++i) EXPECT_NEAR(table(0.5 + 0.01 * i), 1.0, 1e-12);
  for (int i = 0; i < 2667; ++i) {
    const double x = -4 + 0.003 * i;
    EXPECT_LE(table(x), 1.0 + 1e-12);
    EXPECT_GE(table(x), -2.0 - 1e-12);
    EXPECT_NEAR((table(x + 1e-6) - table(x - 1e-6)) / 2e-6, (table(x + 2e-6) - table(x)) / 2e-6, 1e-3);  // smooth
  }
}

TEST(PeriodicTable, OfOnePointIsAConstant) {
  const PeriodicTable table({{0.3, 4.0}}, 1.0);
  for (double x : {-1.0, 0.0, 0.3, 0.9}) EXPECT_EQ(table(x), 4.0);
}

}  // namespace
}  // namespace tiprub::simulate::casing_test
