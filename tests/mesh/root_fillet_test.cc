// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/wheel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "mesh/sector/sector_check.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/mesh/sector_geometry.h"

namespace tiprub::mesh::root_fillet_test {
namespace {

using test::complaint;
using test::geometry_volume;
using test::wheel_from;
using test::with_keys;

constexpr double radius = 0.003, length = 0.03;
constexpr double corner =
    radius * radius * (1.0 - std::numbers::pi / 4.0);  // m^2, between a fillet and its two tangents

/// Straight blades of one thickness on a disc, 60 mm high.
std::string straight_blades(double stagger_deg, const std::string& keys) {
  return with_keys(
      "[mesh]\nfamily = \"bladed_disc\"\nblade_count = 12\nbore_radius = 0.04\nrim_radius = 0.1\n"
      "axial_length = 0.03\ntip_radius = 0.16\nthickness_root = [[0.0, 0.004]]\n"
      "thickness_tip = [[0.0, 0.004]]\nelements_along_chord = 4\nelements_between_blades = 4\n"
      "stagger_root_deg = " +
          std::to_string(stagger_deg) + "\n",
      keys);
}

TEST(RootFillet, AddsTwoCornersToEachBlade) {
  for (const double stagger_deg : {0.0, 40.0}) {
    const double bare = geometry_volume(wheel_from(straight_blades(stagger_deg, "")));
    const double filled = geometry_volume(wheel_from(straight_blades(stagger_deg, "fillet_radius = 0.003\n")));
    const double exact = 2.0 * corner * length / std::cos(stagger_deg * std::numbers::pi / 180.0);
    EXPECT_NEAR((filled - bare) / exact, 1.0, 1e-6) << stagger_deg;
  }
}

TEST(RootFillet, MeshesComeToItsVolume) {
  std::vector<double> errors;
  for (const int elements : {1, 2, 4, 8}) {
    const Wheel wheel =
        wheel_from(straight_blades(0.0, "fillet_radius = 0.003\nelements_along_span = 12\nelements_along_fillet = " +
                                            std::to_string(elements) + "\n"));
    const SectorReport report = measure_sector(mesh_sector(wheel), wheel);
    errors.push_back((report.mesh_volume - geometry_volume(wheel)) / (2.0 * corner * length));
  }
  // The first layer holds a square root: order 3/2, as of any quadratic that stands in for one.
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 1.5, 0.05);
}

TEST(RootFillet, IsACircleThatLeavesTheFlankSmoothly) {
  const std::string keys = "fillet_radius = 0.003\n";
  const Wheel wheel = wheel_from(straight_blades(0.0, keys)), bare = wheel_from(straight_blades(0.0, ""));
  const auto out = [&](double height) {
    const double span = height / 0.06;
    return (0.1 + height) * (wheel.geometry->half_width(BladeKind::main, 0.3, span) -
                             bare.geometry->half_width(BladeKind::main, 0.3, span));
  };
  EXPECT_NEAR(out(0.0), radius, 1e-12);
  for (const double height : {0.0005, 0.0015, 0.0029})
    EXPECT_NEAR(std::hypot(radius - out(height), radius - height), radius, 1e-12);
  EXPECT_NEAR(out(radius), 0.0, 1e-15);
  EXPECT_EQ(out(0.004), 0.0);
}

TEST(RootFillet, EndsWithALayerOfElements) {
  const Wheel wheel = wheel_from(test::case_text("impeller_quick"));
  const SectorPlan& plan = wheel.plan;
  EXPECT_EQ(plan.elements.fillet, 2);
  for (const double station : {0.0, 0.3, 0.77, 1.0}) {
    const double span = plan.span(2 * plan.elements.fillet, wheel.geometry->fillet_end(station));
    EXPECT_NEAR(distance(wheel.geometry->blade_point(station, 0.0), wheel.geometry->blade_point(station, span)),
                0.003, 1e-12);
  }
}

TEST(RootFillet, LeavesTheHubWhereItIs) {
  const MeshedSector mesh = test::sector_from(straight_blades(20.0, "fillet_radius = 0.003\n"));
  for (const std::size_t node : mesh.surface("hub").face_nodes)
    EXPECT_NEAR(mesh.nodes[node].head<2>().norm(), 0.1, 1e-15);
}

TEST(RootFillet, StandsOnMainBladeAndSplitterOfAllFamilies) {
  const std::string bare = test::case_text("fast_impeller");
  for (const std::string& text : {test::case_text("impeller_quick"), with_keys(bare, "fillet_radius = 0.002\n")}) {
    const Wheel wheel = wheel_from(text);
    const SectorReport report = measure_sector(mesh_sector(wheel), wheel);
    EXPECT_GT(report.worst_scaled_jacobian, 0.1);
    EXPECT_NEAR(report.mesh_volume / geometry_volume(wheel), 1.0, 2e-4);
    for (const BladeKind kind : {BladeKind::main, BladeKind::splitter})
      EXPECT_GT(wheel.geometry->half_width(kind, 0.6, 0.0), wheel.geometry->half_width(kind, 0.6, 0.3));
  }
}

TEST(RootFillet, StandsOnBladesOfAFile) {
  const std::string text =
      test::with(test::case_text("rotor37"), "blade_file", "\"" TIPRUB_CASES "/rotor37/blade.txt\"");
  const double bare = geometry_volume(wheel_from(text));
  const Wheel wheel = wheel_from(with_keys(text, "fillet_radius = 0.001\n"));
  EXPECT_GT(measure_sector(mesh_sector(wheel), wheel).worst_scaled_jacobian, 0.05);
  // Two corners along the hub's section, which is 56 mm long.
  const double corners = (geometry_volume(wheel) - bare) / (2.0 * corner / 9.0);
  EXPECT_NEAR(corners, 0.056, 0.001);
}

TEST(RootFillet, RefusesWhatDoesNotFit) {
  const auto message = [](const std::string& keys) { return complaint(straight_blades(0.0, keys)); };
  const auto expect = [&](const std::string& keys, const std::string& phrase) {
    EXPECT_NE(message(keys).find(phrase), std::string::npos) << message(keys);
  };
  expect("fillet_radius = 0.07\n", "fillet_radius = 0.07 must be less than the blade's height, 0.06 m at 0 of");
  expect("fillet_radius = 0.03\n", "fillet_radius makes blades cross: at 0 of the meridional length");
  expect("fillet_radius = -0.001\n", "fillet_radius = -0.001 must be at least 0");
  expect("fillet_radius = 0.003\nelements_along_span = 1\n", "elements_along_span must be at least 2 with a fillet");
  expect("fillet_radius = 0.003\nelements_along_fillet = 8\n",
         "elements_along_fillet = 8 must be at least 1 and at most 7");
  expect("elements_along_fillet = 2\n", "unknown key \"elements_along_fillet\"");
  EXPECT_NE(complaint(test::annular_plate(4) + "fillet_radius = 0.001\n").find("unknown key \"fillet_radius\""),
            std::string::npos);
}

}  // namespace
}  // namespace tiprub::mesh::root_fillet_test
