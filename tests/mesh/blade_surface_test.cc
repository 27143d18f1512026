// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/curves/meridional_curve.h"
#include "mesh/curves/smooth_table.h"
#include "tests/mesh/mesh_cases.h"

namespace tiprub::mesh::blade_surface_test {
namespace {

const MeridionalCurve hub({0.0, 0.03}, {0.06, 0.12}, {0.5, 0.5});
const MeridionalCurve tip({0.0, 0.07}, {0.05, 0.12}, {0.5, 0.5});

TEST(MeridionalCurve, TurnsFromTheAxisToTheRadius) {
  EXPECT_NEAR(hub.at(0.0).r, 0.03, 1e-15);
  EXPECT_NEAR(hub.at(1.0).z, 0.06, 1e-15);
  EXPECT_NEAR(hub.unit_tangent(0.0).z, 1.0, 1e-12);
  EXPECT_NEAR(hub.unit_tangent(1.0).r, 1.0, 1e-12);
}

TEST(MeridionalCurve, IsMeasuredByItsLength) {
  const int pieces = 20000;
  double walked = 0.0;
  for (int i = 0; i < pieces / 2; ++i) {
    const MeridionalPoint step = hub.at((i + 1.0) / pieces) - hub.at(static_cast<double>(i) / pieces);
    walked += std::hypot(step.z, step.r);
  }
  EXPECT_NEAR(walked, 0.5 * hub.length(), 1e-9 * hub.length());
}

TEST(MeridionalCurve, QuarterCircleHasItsLength) {
  const double arm = 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0);
  const MeridionalCurve circle({0.0, 1.0}, {1.0, 2.0}, {arm, arm});
  EXPECT_NEAR(circle.length(), 0.5 * std::numbers::pi, 3e-4 * circle.length());  // the Bezier circle's own error
}

TEST(Impeller, WrapFollowsTheBladeAngle) {
  // d theta / dm = tan(beta) / r, along hub and tip
  const Wheel wheel = test::wheel_from(
      "[mesh]\nfamily = \"impeller\"\nblade_count = 10\ninlet_hub_radius = 0.03\ninlet_tip_radius = 0.07\n"
      "exit_radius = 0.12\nexit_tip_width = 0.01\naxial_length = 0.06\nhub_arms = [0.5, 0.5]\ntip_arms = [0.5, 0.5]\n"
      "hub_angle_deg = [[0.0, -36.0], [1.0, -18.0]]\ntip_angle_deg = [[0.0, -54.0], [0.5, -45.0], [1.0, -27.0]]\n"
      "tip_lean_deg = 9.0\nthickness_root = [[0.0, 0.002]]\nthickness_tip = [[0.0, 0.001]]\nsplitter = false\n"
      "bore_radius = 0.02\nback_profile = [[0.02, 0.08], [0.12, 0.065]]\n");
  constexpr double deg = std::numbers::pi / 180.0;
  const SmoothTable beta_hub({{0.0, -36.0 * deg}, {1.0, -18.0 * deg}});
  const SmoothTable beta_tip({{0.0, -54.0 * deg}, {0.5, -45.0 * deg}, {1.0, -27.0 * deg}});
  const WheelGeometry& blade = *wheel.geometry;
  const double h = 1e-5;
  for (double chord : {0.1, 0.37, 0.8}) {
    const double hub_rate = (blade.theta(chord + h, 0.0) - blade.theta(chord - h, 0.0)) / (2.0 * h * hub.length());
    const double tip_rate = (blade.theta(chord + h, 1.0) - blade.theta(chord - h, 1.0)) / (2.0 * h * tip.length());
    EXPECT_NEAR(hub_rate * hub.at(chord).r, std::tan(beta_hub.at(chord)), 1e-7);
    EXPECT_NEAR(tip_rate * tip.at(chord).r, std::tan(beta_tip.at(chord)), 1e-7);
    const double width = 2.0 * blade.half_width(BladeKind::main, chord, 0.0) * hub.at(chord).r;  // along the circle
    EXPECT_NEAR(0.002 / width, std::cos(beta_hub.at(chord)), 1e-12);
  }
  EXPECT_DOUBLE_EQ(blade.theta(0.0, 1.0), 9.0 * deg);  // the lean
}

}  // namespace
}  // namespace tiprub::mesh::blade_surface_test
