// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/blade_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <sstream>

namespace tiprub::mesh::curve_files_test {
namespace {

const std::string hub = "0.1 0 -1\n0.1 0 1\n", shroud = "# outside\n0 0.2 -1\n0 0.2 1\n";
const std::string profiles =
    "## Main blade\n"
    "# Profile 1 at 0%\n0.09 0.001 0.0 le1\n0.09 0.003 0.01\n0.09 0.002 0.02 te1\n0.09 -0.002 0.02\n0.09 -0.003 "
    "0.01\n0.09 "
    "-0.001 0.0\n"
    "# Profile 2 at 100%\n0.21 0.001 0.0 le1\n0.21 0.003 0.01\n0.21 0.002 0.02 te1\n0.21 -0.002 0.02\n0.21 -0.003 "
    "0.01\n0.21 "
    "-0.001 0.0\n";

std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string said_of_profiles(const std::string& text) {
  const MeridionalPath path = read_path_curve({"hub.curve", hub}, 1.0);
  return complaint([&] { read_profile_curve({"profile.curve", text}, 1.0, path); });
}

TEST(CurveFiles, TellsHowFarAPointIsAlongAndBesideThePath) {
  const MeridionalPath path = {{0.0, 1.0}, {2.0, 1.0}, {2.0, 3.0}};
  EXPECT_DOUBLE_EQ(nearest_on(path, {0.5, 1.25}).along, 0.5);
  EXPECT_DOUBLE_EQ(nearest_on(path, {0.5, 1.25}).beside, 0.25);
  EXPECT_DOUBLE_EQ(nearest_on(path, {2.5, 2.0}).along, 3.0);
  EXPECT_DOUBLE_EQ(nearest_on(path, {2.5, 2.0}).beside, -0.5);
}

TEST(CurveFiles, CutsTheBladeAtHubAndBeforeTheShroud) {
  const MeridionalPath hub_path = read_path_curve({"hub.curve", hub}, 1.0);
  const MeridionalPath shroud_path = read_path_curve({"shroud.curve", shroud}, 1.0);
  const FileBlade blade = read_profile_curve({"profile.curve", profiles}, 1.0, hub_path);
  ASSERT_EQ(blade.sections.size(), 2U);
  const FileBlade cut = cut_to_path(blade, hub_path, shroud_path, 0.01, "profile.curve", "hub.curve");
  EXPECT_NEAR(cut.sections.front().front().at.r, 0.1, 1e-12);
  EXPECT_NEAR(cut.sections.back().back().at.r, 0.19, 1e-12);
  EXPECT_DOUBLE_EQ(cut.sections.back().front().at.z, 0.0);
}

TEST(CurveFiles, RefusesABladeThatDoesNotReachTheHub) {
  const MeridionalPath hub_path = read_path_curve({"hub.curve", "0.05 0 -1\n0.05 0 1\n"}, 1.0);
  const MeridionalPath shroud_path = read_path_curve({"shroud.curve", shroud}, 1.0);
  const FileBlade blade = read_profile_curve({"profile.curve", profiles}, 1.0, hub_path);
  EXPECT_NE(complaint([&] {
              cut_to_path(blade, hub_path, shroud_path, 0.0, "profile.curve", "hub.curve");
            }).find("m above hub.curve at 0 of its length; its first profile must lie on the hub or below"),
            std::string::npos);
}

/// Symptom: a blade near theta = 180 degrees, whose lean leads across, was refused as having inverted elements.
TEST(CurveFiles, CountTheAnglesOnFromProfileToProfile) {
  const MeridionalPath path = read_path_curve({"hub.curve", hub}, 1.0);
  const auto blade = [&](double turn) {
    std::ostringstream text;
    for (int k = 0; k < 4; ++k) {
      text << "# Profile\n";
      for (int i = 0; i < 6; ++i) {
        const int along = i < 4 ? i : 6 - i, side = i % 3 == 0 ? 0 : i < 3 ? 1 : -1;
        const double r = 0.1 + 0.02 * k, theta = turn + 0.1 * k + 0.05 * along + 0.01 * side;
        text << r * std::cos(theta) << " " << r * std::sin(theta) << " " << 0.01 * along << "\n";
      }
    }
    return read_profile_curve({"profile.curve", text.str()}, 1.0, path);
  };
  const FileBlade at_zero = blade(0.0), across = blade(2.95);
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < at_zero.sections[k].size(); ++i)
      EXPECT_NEAR(across.sections[k][i].theta - at_zero.sections[k][i].theta, 2.95, 1e-4);
}

TEST(CurveFiles, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(said_of_profiles(profiles), "");
  EXPECT_EQ(said_of_profiles(changed(profiles, "0.003 0.01\n", "0.003\n")),
            "profile.curve:4: no z, which must be a finite number");
  EXPECT_EQ(said_of_profiles(changed(profiles, "te1", "edge")),
            "profile.curve:5: a point is x, y, z and perhaps a mark le or te; there is more");
  EXPECT_EQ(said_of_profiles(changed(profiles, "# Profile 2", "## Splitter")),
            "profile.curve:9: a second blade begins here; only one can be taken: leave splitters out");
  EXPECT_EQ(said_of_profiles(profiles.substr(0, profiles.find("# Profile 2"))),
            "profile.curve: holds 1 sections of a blade; it must hold two or more, from hub to tip");
  EXPECT_EQ(said_of_profiles("# Profile 1\n0.1 0 0\n0.1 0 1\n"),
            "profile.curve:2: the profile that begins here has 2 points, and needs 6");
  EXPECT_EQ(complaint([] {
              read_path_curve({"hub.curve", "0.1 0 0\n"}, 1.0);
            }),
            "hub.curve: holds 1 points; it must hold two or more, x y z a line, from inlet to outlet");
}

}  // namespace
}  // namespace tiprub::mesh::curve_files_test
