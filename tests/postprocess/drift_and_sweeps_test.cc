// SPDX-License-Identifier: GPL-3.0-or-later
// The contact's drift with speed, and what sweeps came to beside the response from rest.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "cases/errors.h"
#include "postprocess/contact_drift.h"
#include "postprocess/sweep_comparison.h"
#include "simulate/response_file.h"
#include "synthetic_scene.h"

namespace fs = std::filesystem;

namespace tiprub {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Contact over a fifth of each lobe around a middle that moves by `slope` a rad/s.
ContactMap moving_contact(const Eigen::VectorXd& speeds, int lobes, double slope, double start) {
  constexpr int areas = 3600;
  ContactMap map{Eigen::MatrixXd::Zero(areas, speeds.size()), {}, {}};
  for (Eigen::Index i = 0; i < speeds.size(); ++i)
    for (int area = 0; area < areas; ++area) {
      const double lobe = lobes * (turn * (area + 0.5) / areas - start - slope * speeds[i]) / turn;
      if (std::abs(lobe - std::round(lobe)) < 0.1) map.share(area, i) = 1;
    }
  return map;
}

TEST(ContactDrift, FindsALineThatRunsOverSeveralLobes) {
  const ContactLine contact = synthetic::model().contact;
  const Eigen::VectorXd speeds = Eigen::VectorXd::LinSpaced(60, 700, 5700);
  const double slope = 1e-3;  // 5 rad in all: more than one lobe
  for (const int lobes : {2, 3}) {
    const ContactDrift drift = contact_drift(moving_contact(speeds, lobes, slope, 0.2), speeds, lobes, contact);
    EXPECT_NEAR(drift.slope, slope, 1e-3 * slope);
    EXPECT_GT(drift.determination, 0.99999);
    EXPECT_NEAR(std::remainder(drift.intercept - 0.2, turn / lobes), 0, 2e-3);
    const double length = contact.arc_length[contact.size() - 1] - contact.arc_length[0];
    EXPECT_NEAR(drift.implied_wave_speed, length / slope, 1e-2 * length / slope);
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

class Sweeps : public testing::Test {
 protected:
  Sweeps()
      : folder_(fs::temp_directory_path() / ("tiprub-sweeps-" + std::to_string(getpid()))),
        model_(synthetic::model()) {
    fs::create_directories(folder_);
    rest_.scene = synthetic::two_lobes();
    rest_.scene.casing_angle = Eigen::VectorXd::LinSpaced(5, 0, turn);
    rest_.scene.casing_distortion = Eigen::VectorXd::Zero(5);
    rest_.scene.clearance = Eigen::VectorXd::Constant(model_.contact.size(), 1e-4);
    for (const double speed : {1000.0, 1100.0, 1200.0}) rest_.speeds.push_back(at(speed, 1e-5));
  }
  ~Sweeps() override { fs::remove_all(folder_); }

  SpeedResponse at(double speed, double amplitude) const {
    SpeedResponse made = synthetic::speed(rest_.scene, model_.contact, speed, {{2, 2, amplitude, 0.3}});
    made.motion = MotionClass::periodic;
    made.period_revolutions = 1;
    return made;
  }

  std::vector<SweepComparison> compared(const Response& up) const {
    const fs::path file = folder_ / "up.h5";
    write_response(up, file, "test");
    return compare_sweeps(rest_, model_.contact, 0, Component::normal, file, {});
  }

  fs::path folder_;
  ReducedModel model_;
  Response rest_;
};

TEST_F(Sweeps, DifferOnlyWhereTheMotionDoes) {
  Response up = rest_;
  up.speeds[1] = at(1100, 3e-5);
  const std::vector<SweepComparison> found = compared(up);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_FALSE(found[0].differs());
  EXPECT_TRUE(found[1].differs());
  EXPECT_NEAR(found[1].up->difference, 2.0 / 3, 1e-6);
  EXPECT_NEAR(found[1].up->amplitude, 3e-5, 1e-3 * 3e-5);  // a sample need not meet the crest
  EXPECT_FALSE(found[2].down.has_value());
}

TEST_F(Sweeps, IrregularMotionIsNotCalledAnotherSolution) {
  Response up = rest_;
  up.speeds[1] = at(1100, 3e-5);
  up.speeds[1].motion = MotionClass::irregular;
  EXPECT_FALSE(compared(up)[1].differs());
}

TEST_F(Sweeps, SpeedsThatOnlyOneHasAreLeftAlone) {
  Response up = rest_;
  up.speeds.erase(up.speeds.begin());
  EXPECT_FALSE(compared(up)[0].up.has_value());
  EXPECT_TRUE(compared(up)[1].up.has_value());
}

TEST_F(Sweeps, OfAnotherCasingAreRefused) {
  Response up = rest_;
  up.scene.clearance[0] *= 2;
  EXPECT_THROW(compared(up), InputError);
}

TEST_F(Sweeps, AreNoneUnlessAskedFor) {
  EXPECT_TRUE(compare_sweeps(rest_, model_.contact, 0, Component::normal, {}, {}).empty());
}

}  // namespace
}  // namespace tiprub
