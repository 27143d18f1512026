// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/contact_maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "synthetic_scene.h"

namespace tiprub::postprocess {
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
    EXPECT_NEAR(drift.line.slope, slope, bounds.slope);
    EXPECT_GT(drift.line.determination, 1 - bounds.determination);
    EXPECT_NEAR(std::remainder(drift.line.intercept - 0.2, turn / lobes), 0, bounds.intercept);
    const double length = contact.arc_length[contact.size() - 1] - contact.arc_length[0];
    EXPECT_NEAR(drift.implied_wave_speed * drift.line.slope, length, rounding * length);
  }
}

TEST(ContactDrift, HasNoLineWithoutContact) {
  const Eigen::VectorXd speeds = Eigen::VectorXd::LinSpaced(5, 700, 5700);
  const ContactMap none{Eigen::MatrixXd::Zero(200, 5), {}, {}};
  const ContactDrift drift = contact_drift(none, speeds, 2, synthetic::model().contact);
  EXPECT_TRUE(std::isnan(drift.line.slope));
  EXPECT_TRUE(std::isnan(drift.line.determination));
  EXPECT_TRUE(drift.angle.array().isNaN().all());
}

/// Force pulses on both edges as the two lobes pass; the leading edge's come `lag` [s] late. From the resonance on
/// both edges rub a quarter of a turn further on: between the lobes.
Response passed_on_contact(const ReducedModel& rotor, double lag) {
  constexpr double width = 0.06;  // [rad]
  constexpr double resonance = 1500;
  Response response{synthetic::two_lobes(), "made", {}, {}};
  for (int i = 0; i <= 20; ++i) {
    const double speed = 1000 + 50.0 * i;
    SpeedResponse made = synthetic::speed(response.scene, rotor.contact, speed, {}, 2);
    made.contact_force.setZero();
    made.contact_count.setZero();
    for (int sample = 0; sample < made.contact_force.rows(); ++sample)
      for (int sector = 0; sector < response.scene.independent_sectors; ++sector)
        for (const int node : {0, rotor.contact.size() - 1}) {
          const double angle = rotor.contact.position(node, 1) + turn * sector / 10 +
                               turn * sample / made.samples_per_revolution - (node == 0 ? lag * speed : 0) -
                               (speed > resonance ? turn / 4 : 0);
          const double off = 0.5 * std::remainder(2 * angle, turn);
          const int point = sector * rotor.contact.size() + node;
          made.contact_force(sample, point) = std::exp(-0.5 * std::pow(off / width, 2));
          const double place = rotor.contact.position(node, 1) / turn + 0.1 * sector +
                               static_cast<double>(sample) / made.samples_per_revolution;
          if (std::abs(off) < width)
            ++made.contact_count(point, static_cast<int>((place - std::floor(place)) * 200) % 200);
        }
    response.speeds.push_back(made);
  }
  return response;
}

/// Symptom: the middle of the leading edge's contact, followed over speed, flipped at resonances: R^2 0.17 over the
/// range, and no slope to speak of. What a wave along the blade does is to make one edge later than the other.
TEST(EdgeLag, SurvivesAFlipOfTheMiddle) {
  constexpr double lag = 3e-5, hundredth_of_a_sample = 0.01 / 360;  // of a revolution
  const ReducedModel rotor = synthetic::model();
  const Response response = passed_on_contact(rotor, lag);
  Eigen::VectorXd speeds(static_cast<Eigen::Index>(response.speeds.size()));
  for (Eigen::Index i = 0; i < speeds.size(); ++i) speeds[i] = response.speeds[static_cast<std::size_t>(i)].speed;
  const ContactDrift middle = contact_drift(contact_map(response, rotor.contact, 0), speeds, 2, rotor.contact);
  EXPECT_GT(std::abs(middle.line.slope - lag), 10 * lag);  // the flip makes it

  const EdgeLag found = edge_lag(response, rotor.contact);
  for (Eigen::Index i = 0; i < speeds.size(); ++i) {
    EXPECT_NEAR(found.time[i], lag, hundredth_of_a_sample * turn / speeds[i]) << speeds[i];
    EXPECT_GT(found.likeness[i], 0.99);
  }
  EXPECT_NEAR(found.line.slope, lag, 0.01 * lag);
  EXPECT_GT(found.line.determination, 0.999);
  EXPECT_NEAR(found.median, lag, 0.01 * lag);
  EXPECT_LE(found.lower_quartile, found.median);
  EXPECT_GE(found.upper_quartile, found.median);
}

TEST(EdgeLag, IsUnknownUnlessBothEdgesTouch) {
  const ReducedModel rotor = synthetic::model();
  Response response = passed_on_contact(rotor, 0);
  for (SpeedResponse& speed : response.speeds)
    for (int sector = 0; sector < 5; ++sector) speed.contact_force.col(sector * rotor.contact.size()).setZero();
  const EdgeLag found = edge_lag(response, rotor.contact);
  EXPECT_TRUE(found.time.array().isNaN().all());
  EXPECT_TRUE(std::isnan(found.line.determination));
  EXPECT_TRUE(std::isnan(found.median));
}

}  // namespace
}  // namespace tiprub::postprocess
