// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/other_motions.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>

#include "cases/program/errors.h"
#include "simulate/response/response_file.h"
#include "synthetic_scene.h"
#include "tests/simulate/written_response.h"

namespace fs = std::filesystem;

namespace tiprub::postprocess::sweep_comparison_test {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double rounding = 1e-13;

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
    return compare_sweeps(rest_, model_.contact, 0, Component::normal, {.up = file, .down = {}});
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
  EXPECT_NEAR(found[1].up->difference, 2.0 / 3, rounding);
  // The crest falls between two samples: at most half a sample away, on engine order 2. It is never overshot.
  const double half_sample = 2 * 0.5 * turn / up.speeds[1].samples_per_revolution;
  EXPECT_LE(found[1].up->amplitude, 3e-5 * (1 + rounding));
  EXPECT_GE(found[1].up->amplitude, 3e-5 * (std::cos(half_sample) - rounding));
  EXPECT_FALSE(found[2].down.has_value());
}

TEST_F(Sweeps, PeriodicMotionsDifferWhereOneStillSettles) {
  Response up = rest_;
  up.speeds[1] = at(1100, 3e-5);
  up.speeds[1].period_revolutions = 0;
  EXPECT_TRUE(compared(up)[1].differs());
}

TEST_F(Sweeps, IrregularMotionIsNotCalledAnotherSolution) {
  Response up = rest_;
  up.speeds[1] = at(1100, 3e-5);
  up.speeds[1].motion = MotionClass::broadband;
  up.speeds[1].period_revolutions = 0;
  EXPECT_FALSE(compared(up)[1].differs());
}

TEST_F(Sweeps, IrregularMotionOfAnotherSizeIs) {
  // A sweep that stays on a high branch, on which the motion never settles: 0.8 of the larger, more than chance
  // makes.
  Response up = rest_;
  up.speeds[1] = at(1100, 5e-5);
  up.speeds[1].motion = MotionClass::broadband;
  up.speeds[1].period_revolutions = 0;
  EXPECT_TRUE(compared(up)[1].differs());
}

TEST_F(Sweeps, SpeedsThatOnlyOneHasAreLeftAlone) {
  Response up = rest_;
  up.speeds.erase(up.speeds.begin());
  EXPECT_FALSE(compared(up)[0].up.has_value());
  EXPECT_TRUE(compared(up)[1].up.has_value());
}

TEST_F(Sweeps, SpeedsThatFailedAreLeftAlone) {
  // A failed speed of a sweep holds no motion: its amplitudes were asked for all the same, out of an empty matrix.
  Response up = rest_;
  up.speeds[1] = {};
  up.speeds[1].speed = 1100;
  up.speeds[1].failure = "it blew up";
  const std::vector<SweepComparison> found = compared(up);
  EXPECT_TRUE(found[0].up.has_value());
  EXPECT_FALSE(found[1].up.has_value());
  EXPECT_TRUE(found[2].up.has_value());
}

TEST_F(Sweeps, OfAnotherCasingAreRefused) {
  Response up = rest_;
  up.scene.clearance[0] *= 2;
  EXPECT_THROW(compared(up), InputError);
}

/// Symptom: with friction in one of them only, the report said that more than one motion exists.
TEST_F(Sweeps, OfAnotherPhysicsAreRefused) {
  const auto refusal = [&](const std::function<void(SimulatedScene&)>& change) {
    Response up = rest_;
    change(up.scene);
    try {
      compared(up);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(message.find(": is ") + 2);
    }
    return std::string();
  };
  EXPECT_EQ(refusal([](SimulatedScene&) {}), "");
  EXPECT_EQ(refusal([](SimulatedScene& scene) { scene.casing = "friction_coefficient = 0.1\n"; }),
            "is of another [casing] friction_coefficient than the response; sweep this case");
  EXPECT_EQ(refusal([](SimulatedScene& scene) { scene.damping.by_family = {0.017}; }),
            "is of another damping than the response; sweep this case");
  EXPECT_EQ(refusal([](SimulatedScene& scene) { scene.effects.front().treatment = Treatment::modelled; }),
            "is of another choice of what is modelled than the response; sweep this case");
  EXPECT_EQ(refusal([](SimulatedScene& scene) { scene.provenance = "# case\n[simulate]\nsweep = \"up\"\n"; }), "");
  EXPECT_EQ(refusal([](SimulatedScene& scene) { scene.provenance = "# case\n[simulate]\nsweep = \"down\"\n"; }),
            "is no sweep up; run tiprub-simulate with --set 'simulate.sweep=\"up\"'");
}

TEST_F(Sweeps, AreNoneUnlessAskedFor) {
  EXPECT_TRUE(compare_sweeps(rest_, model_.contact, 0, Component::normal, {}).empty());
}

}  // namespace
}  // namespace tiprub::postprocess::sweep_comparison_test
