// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/casing_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>

#include "cases/program/errors.h"

namespace tiprub::simulate {
namespace {

constexpr double pi = std::numbers::pi;

const std::string sound =
    "# a rig's probes, lobe by lobe\n"
    "angle_deg, 0.0, 0.25, 1.0\n"
    "0, 1e-4, 2e-4, -4e-4   # the flange\n"
    "45,0,0,0\r\n"
    "90\t-1e-4\t-2e-4\t0\n";

std::string complaint(const std::string& text) {
  try {
    read_casing_profile({"casing.csv", text}, pi);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CasingProfile, GoesThroughItsPointsAndIsLinearOverTheChord) {
  const CasingProfile profile = read_casing_profile({"casing.csv", sound}, pi);
  for (const double turned : {0.0, pi, -7 * pi}) {
    EXPECT_NEAR(profile(turned, 0.0), 1e-4, 1e-17);
    EXPECT_NEAR(profile(turned, 0.25), 2e-4, 1e-17);
    EXPECT_NEAR(profile(turned, 0.125), 1.5e-4, 1e-17);
    EXPECT_NEAR(profile(turned, 0.75), (2e-4 / 3 - 4e-4 * 2 / 3), 1e-17);
    EXPECT_NEAR(profile(turned, 1.0), -4e-4, 1e-17);
    EXPECT_NEAR(profile(turned + pi / 2, 0.25), -2e-4, 1e-17);
  }
  EXPECT_EQ(profile.largest(), 4e-4);
}

TEST(CasingProfile, IsLevelOutsideItsStations) {
  const CasingProfile profile = read_casing_profile({"casing.csv", "a 0.4 0.6\n10 1e-4 3e-4\n"}, 2 * pi);
  for (const double angle : {0.0, 1.0, 6.0}) {
    EXPECT_NEAR(profile(angle, 0.0), 1e-4, 1e-17);
    EXPECT_NEAR(profile(angle, 0.5), 2e-4, 1e-17);
    EXPECT_NEAR(profile(angle, 1.0), 3e-4, 1e-17);
  }
}

/// Measured at every degree, a cosine is met to the order of the interpolation.
TEST(CasingProfile, FollowsACosineThatWasMeasured) {
  std::string text = "angle 0 1\n";
  for (int degree = 0; degree < 180; ++degree) {
    const double inward = 2e-4 * std::cos(2 * pi * degree / 180);
    text +=
        std::to_string(degree) + " " + std::to_string(1e6 * inward) + "e-6 " + std::to_string(5e5 * inward) + "e-6\n";
  }
  const CasingProfile profile = read_casing_profile({"casing.csv", text}, pi);
  for (int i = 0; i < 800; ++i) {
    const double angle = -4 + 0.01 * i;
    EXPECT_NEAR(profile(angle, 0.5), 0.75 * 2e-4 * std::cos(2 * angle), 3e-4 * 2e-4);
  }
}

struct Wrong {
  const char* name;
  const char* from;
  const char* to;
  const char* message;
};
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.name;
}

class WrongProfile : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongProfile, IsRefusedAtItsLine) {
  std::string text = sound;
  text.replace(text.find(GetParam().from), std::string(GetParam().from).size(), GetParam().to);
  EXPECT_EQ(complaint(text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Message, WrongProfile,
    ::testing::Values(
        Wrong{"station", "0.25", "1.25",
              "casing.csv:2: must be a word and then fractions of the arc length, increasing in 0 .. 1; \"1.25\" "
              "isn't"},
        Wrong{
            "descending", "0.25", "0.0",
            "casing.csv:2: must be a word and then fractions of the arc length, increasing in 0 .. 1; \"0.0\" isn't"},
        Wrong{"no_stations", ", 0.0, 0.25, 1.0", "",
              "casing.csv:2: must be \"angle_deg\" and the fractions of the arc length of the columns"},
        Wrong{"columns", "45,0,0,0", "45,0,0",
              "casing.csv:4: has 3 words, and must have 4: an angle [deg], and for each fraction how far inward [m]"},
        Wrong{"angle", "90\t", "180\t",
              "casing.csv:5: angles must increase in 0 .. 180 deg, that end excluded; 180 doesn't"},
        Wrong{"angle_twice", "90\t", "45\t",
              "casing.csv:5: angles must increase in 0 .. 180 deg, that end excluded; 45 doesn't"},
        Wrong{"not_finite", "45,0", "45,nan",
              "casing.csv:4: \"nan\" stands for how far inward [m], which must be a finite number"},
        Wrong{"word", "-2e-4", "wide",
              "casing.csv:5: \"wide\" stands for how far inward [m], which must be a finite number"},
        Wrong{"empty", sound.c_str(), "# nothing\n",
              "casing.csv:1: must hold a line of fractions of the arc length, and one for each angle"}),
    [](const auto& wrong) { return wrong.param.name; });

}  // namespace
}  // namespace tiprub::simulate
