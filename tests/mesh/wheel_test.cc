// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/wheel.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

#include "tests/mesh/mesh_cases.h"

namespace tiprub::mesh::wheel_test {
namespace {

using test::case_text;
using test::complaint;
using test::wheel_from;
using test::with;

TEST(Wheel, TheSplitterAlwaysStartsBetweenTwoElements) {
  const Wheel wheel = wheel_from(case_text("fast_impeller"));
  EXPECT_DOUBLE_EQ(wheel.plan.station(2 * wheel.plan.elements.upstream), 0.45);
  EXPECT_DOUBLE_EQ(wheel.plan.station(2 * wheel.plan.elements.chord), 1.0);
}

TEST(Wheel, DefaultsMeshTheRootAndTheDiscAsAsked) {
  const Wheel wheel = wheel_from(test::twisted_blades());
  EXPECT_GE(wheel.plan.elements.blade, 3);  // 2 through a blade, 3 at its root: one count, since blocks conform
  EXPECT_GE(wheel.plan.elements.disc, 3);
  EXPECT_EQ(wheel.plan.element, ElementKind::hex20);
}

TEST(Wheel, AThickTipIsAllowedWhereNoSplitterStands) {
  // Two such edges take 0.37 rad; from blade to splitter there are 0.31 rad, from blade to blade 0.63 rad.
  EXPECT_EQ(
      complaint(with(case_text("fast_impeller"), "thickness_tip", "[[0.0, 0.016], [0.3, 0.001], [1.0, 0.001]]")), "");
}

TEST(Wheel, TheLeadingEdgeLeansByItsKey) {
  const auto lean = [](const Wheel& wheel) {
    return wheel.geometry->theta(0.0, 1.0) - wheel.geometry->theta(0.0, 0.0);
  };
  const std::string text = case_text("fast_impeller");
  const Wheel leaning = wheel_from(test::with_keys(text, "tip_lean_deg = 9.0\n"));
  EXPECT_NEAR(lean(leaning) - lean(wheel_from(text)), EIGEN_PI / 20.0, 1e-12);
}

/// Symptom: blades that cross in the middle of the span were meshed, because only hub and tip were looked at.
TEST(Wheel, BladesMustNotCrossBetweenHubAndTip) {
  const std::string path = ::testing::TempDir() + "thick_in_the_middle.txt";
  const auto said = [&](double middle) {
    std::ofstream file(path);
    for (const auto& [r, width] : {std::pair{0.06, 0.01}, {0.08, middle}, {0.1, 0.01}})
      for (const double z : {-0.01, 0.0, 0.01})
        file << (z < 0 ? "section\n" : "") << z << " " << r << " " << 0.5 * width << " " << -0.5 * width << "\n";
    file.close();
    return complaint("[mesh]\nfamily = \"blade_file\"\nblade_format = \"sections\"\nblade_file = \"" + path +
                     "\"\nlength_unit = \"m\"\nblade_count = 12\ndisc = \"profile\"\nbore_radius = 0.03\n");
  };
  EXPECT_EQ(said(0.3), "");
  EXPECT_NE(said(0.6).find("blade_file makes blades cross: at 0 of the meridional length and 0.375 of the "
                           "way from hub to tip they take 0.535469 rad"),
            std::string::npos)
      << said(0.6);
  std::filesystem::remove(path);
}

struct Wrong {
  const char* key;
  const char* value;
  const char* phrase;
};

/// A readable name for each case: the default prints addresses, which change from run to run.
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.key;
}

class WrongKey : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongKey, IsRefusedInPlainWords) {
  const auto [key, value, phrase] = GetParam();
  const std::string message = complaint(with(case_text("fast_impeller"), key, value));
  EXPECT_NE(message.find(phrase), std::string::npos) << message;
  EXPECT_NE(message.find(".toml:"), std::string::npos) << message;  // file and line
}

INSTANTIATE_TEST_SUITE_P(
    Impeller, WrongKey,
    ::testing::Values(
        Wrong{"exit_tip_width", "0.07", "must be less than axial_length"},
        Wrong{"inlet_tip_radius", "0.03", "must be more than inlet_hub_radius"},
        Wrong{"exit_radius", "0.07", "must be more than inlet_tip_radius"},
        Wrong{"hub_arms", "[0.4]", "must hold two numbers"},
        Wrong{"hub_angle_deg", "[[0.0, -38.0], [0.9, -28.0]]", "from chord fraction 0 to chord fraction 1"},
        Wrong{"tip_angle_deg", "[[0.0, -88.0]]", "tip_angle_deg = -88 must be at least -80"},
        Wrong{"back_profile", "[[0.03, 0.092], [0.122, 0.07]]", "must go from bore_radius to exit_radius"},
        Wrong{"thickness_tip", "[[0.0, 0.04]]", "thickness_tip makes blades cross"},
        Wrong{"elements_along_chord", "1", "must be at least 2"}, Wrong{"blade_count", "2", "must be at least 3"},
        Wrong{"axial_length", "nan", "must be a finite number"}));

}  // namespace
}  // namespace tiprub::mesh::wheel_test
