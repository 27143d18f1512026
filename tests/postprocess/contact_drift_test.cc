// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/contact_drift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "synthetic_scene.h"

namespace tiprub {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double rounding = 1e-13;
constexpr int casing_areas = 3600;

/// Contact over a fifth of each lobe around a middle that moves by `slope` a rad/s.
ContactMap moving_contact(const Eigen::VectorXd& speeds, int lobes, double slope, double start) {
  ContactMap map{Eigen::MatrixXd::Zero(casing_areas, speeds.size()), {}, {}};
  for (Eigen::Index i = 0; i < speeds.size(); ++i)
    for (int area = 0; area < casing_areas; ++area) {
      const double lobe = lobes * (turn * (area + 0.5) / casing_areas - start - slope * speeds[i]) / turn;
      if (std::abs(lobe - std::round(lobe)) < 0.1) map.share(area, i) = 1;
    }
  return map;
}

/// What areas of finite size leave of a line through `speeds`. The areas in contact run from the first centre after
/// one end of the contact to the last before the other: their middle is off by less than half an area, e. Least
/// squares weigh these with w_i = (x_i - mean x)/S, S the sum of their squares, for the slope, and 1/n - w_i mean x
/// for the intercept; the squares of its residuals sum to no more than those of the true line, n e^2.
struct DriftBounds {
  double slope = 0, intercept = 0, determination = 0;
};

DriftBounds drift_bounds(const Eigen::VectorXd& speeds, double slope) {
  const double half_area = 0.5 * turn / casing_areas, count = static_cast<double>(speeds.size());
  const Eigen::ArrayXd x = speeds.array() - speeds.mean();
  const Eigen::ArrayXd weights = x / x.square().sum();
  const double spread = slope * x.matrix().norm() - half_area * std::sqrt(count);  // at least, of the angles found
  return {half_area * weights.abs().sum(), half_area * (1 / count - weights * speeds.mean()).abs().sum(),
          count * std::pow(half_area / spread, 2)};
}

TEST(ContactDrift, FindsALineThatRunsOverSeveralLobes) {
  const ContactLine contact = synthetic::model().contact;
  const Eigen::VectorXd speeds = Eigen::VectorXd::LinSpaced(60, 700, 5700);
  const double slope = 1e-3;  // 5 rad in all: more than one lobe
  const DriftBounds bounds = drift_bounds(speeds, slope);
  for (const int lobes : {2, 3}) {
    const ContactDrift drift = contact_drift(moving_contact(speeds, lobes, slope, 0.2), speeds, lobes, contact);
    EXPECT_NEAR(drift.slope, slope, bounds.slope);
    EXPECT_GT(drift.determination, 1 - bounds.determination);
    EXPECT_NEAR(std::remainder(drift.intercept - 0.2, turn / lobes), 0, bounds.intercept);
    const double length = contact.arc_length[contact.size() - 1] - contact.arc_length[0];
    EXPECT_NEAR(drift.implied_wave_speed * drift.slope, length, rounding * length);
  }
}

TEST(ContactDrift, HasNoLineWithoutContact) {
  const Eigen::VectorXd speeds = Eigen::VectorXd::LinSpaced(5, 700, 5700);
  const ContactMap none{Eigen::MatrixXd::Zero(200, 5), {}, {}};
  const ContactDrift drift = contact_drift(none, speeds, 2, synthetic::model().contact);
  EXPECT_EQ(drift.slope, 0);
  EXPECT_EQ(drift.determination, 0);
  EXPECT_TRUE(drift.angle.array().isNaN().all());
}

}  // namespace
}  // namespace tiprub
