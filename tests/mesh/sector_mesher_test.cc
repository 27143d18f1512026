// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_mesher.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "mesh/sector/sector_check.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/mesh/sector_geometry.h"

namespace tiprub::mesh {
namespace {

using test::annular_plate;
using test::case_text;
using test::sector_from;
using test::wheel_from;
using test::with;

// Nodes of a box of a x b x c quadratic cells.
std::size_t box_nodes(std::size_t a, std::size_t b, std::size_t c, ElementKind kind) {
  if (kind == ElementKind::hex27) return (2 * a + 1) * (2 * b + 1) * (2 * c + 1);
  const std::size_t corners = (a + 1) * (b + 1) * (c + 1);
  return corners + a * (b + 1) * (c + 1) + (a + 1) * b * (c + 1) + (a + 1) * (b + 1) * c;
}

TEST(SectorMesher, CountsNodesOfBothKinds) {
  EXPECT_EQ(sector_from(annular_plate(4, "hex20")).nodes.size(), box_nodes(4, 1, 2, ElementKind::hex20));
  EXPECT_EQ(sector_from(annular_plate(4, "hex27")).nodes.size(), box_nodes(4, 1, 2, ElementKind::hex27));
}

TEST(SectorMesher, CyclicFacesPairToRoundOff) {
  const MeshedSector mesh = sector_from(case_text("fast_impeller"));
  const double alpha = 2.0 * std::numbers::pi / mesh.sector_count;
  std::set<std::size_t> lows, highs;
  for (const auto& [low, high] : test::cyclic_pairs(mesh)) {
    const Eigen::Vector3d& a = mesh.nodes[low];
    const Eigen::Vector3d& b = mesh.nodes[high];
    EXPECT_NEAR(a[0] * std::cos(alpha) - a[1] * std::sin(alpha), b[0], 1e-15);
    EXPECT_NEAR(a[0] * std::sin(alpha) + a[1] * std::cos(alpha), b[1], 1e-15);
    EXPECT_EQ(a[2], b[2]);
    lows.insert(low);
    highs.insert(high);
  }
  const auto& low_faces = mesh.surface("cyclic_low").face_nodes;
  const auto& high_faces = mesh.surface("cyclic_high").face_nodes;
  EXPECT_EQ(std::set<std::size_t>(low_faces.begin(), low_faces.end()), lows);
  EXPECT_EQ(std::set<std::size_t>(high_faces.begin(), high_faces.end()), highs);
}

TEST(SectorMesher, VolumeOfAnAnnularPlateConvergesWithFourthOrder) {
  const double exact = std::numbers::pi * (0.2 * 0.2 - 0.1 * 0.1) * 0.001 / 6.0;
  std::vector<double> errors;
  for (int elements : {1, 2, 4, 8}) {
    const Wheel wheel = wheel_from(annular_plate(elements));
    const SectorReport report = measure_sector(mesh_sector(wheel), wheel);
    errors.push_back(std::abs(report.mesh_volume / exact - 1.0));
    EXPECT_NEAR(test::geometry_volume(wheel) / exact, 1.0, 1e-9);
  }
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 4.0, 0.1);
}

TEST(SectorMesher, FullQuadraticCellsConvergeToo) {
  std::vector<double> errors;
  for (int elements : {2, 4}) {
    const Wheel wheel = wheel_from(annular_plate(elements, "hex27"));
    const SectorReport report = measure_sector(mesh_sector(wheel), wheel);
    errors.push_back(std::abs(report.mesh_volume / test::geometry_volume(wheel) - 1.0));
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4.0, 0.1);
}

TEST(SectorMesher, ClampsTheBoreAndNothingElse) {
  const MeshedSector mesh = sector_from(case_text("fast_impeller"));
  const std::vector<std::size_t>& nodes = mesh.surface("clamped").face_nodes;
  const std::set<std::size_t> clamped(nodes.begin(), nodes.end());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const bool on_bore = std::abs(mesh.nodes[n].head<2>().norm() - 0.028) < 1e-9;
    EXPECT_EQ(clamped.count(n), on_bore ? 1u : 0u) << n;
  }
}

TEST(SectorMesher, CanClampTheFrontFaceInstead) {
  const MeshedSector mesh = sector_from(with(case_text("fast_impeller"), "clamped", "\"front_face\""));
  for (std::size_t node : mesh.surface("clamped").face_nodes) EXPECT_NEAR(mesh.nodes[node][2], 0.0, 1e-15);
}

TEST(SectorMesher, ContactRunsAlongTheMainBladesTipFromLeadingToTrailingEdge) {
  const MeshedSector mesh = sector_from(case_text("fast_impeller"));
  const std::vector<std::size_t>& tip = mesh.surface("blade_tip").face_nodes;
  const std::set<std::size_t> tip_nodes(tip.begin(), tip.end());
  ASSERT_EQ(mesh.contact.size(), 11u);
  for (std::size_t node : mesh.contact) EXPECT_TRUE(tip_nodes.count(node));
  EXPECT_NEAR(mesh.nodes[mesh.contact.front()].head<2>().norm(), 0.088, 1e-12);
  EXPECT_NEAR(mesh.nodes[mesh.contact.back()].head<2>().norm(), 0.122, 1e-12);
  for (std::size_t n = 1; n < mesh.contact.size(); ++n)
    EXPECT_GT(mesh.nodes[mesh.contact[n]][2], mesh.nodes[mesh.contact[n - 1]][2]);
}

TEST(SectorMesher, AnEvenCountThroughTheBladeHasContactNodesBetweenStationsToo) {
  EXPECT_EQ(sector_from(with(case_text("fast_impeller"), "elements_through_blade", "2")).contact.size(), 21u);
}

TEST(SectorMesher, FacesLookOutward) {
  const MeshedSector mesh = sector_from(case_text("fast_impeller"));
  const auto normal = [&](const std::string& name) {
    const std::vector<std::size_t>& n = mesh.surface(name).face_nodes;
    const auto x = [&](int corner) { return mesh.nodes[n[corner]]; };
    return Eigen::Vector3d((x(2) - x(0)).cross(x(3) - x(1)));
  };
  const auto radial = [&](const std::string& name) {
    return normal(name).head<2>().dot(mesh.nodes[mesh.surface(name).face_nodes[0]].head<2>());
  };
  EXPECT_LT(radial("clamped"), 0.0);
  EXPECT_GT(radial("hub"), 0.0);
  EXPECT_GT(radial("blade_tip"), 0.0);
  // cyclic_low faces the sector before, cyclic_high the one after
  const auto along_theta = [&](const std::string& name) {
    const Eigen::Vector3d& at = mesh.nodes[mesh.surface(name).face_nodes[0]];
    return Eigen::Vector3d(-at[1], at[0], 0.0).dot(normal(name));
  };
  EXPECT_LT(along_theta("cyclic_low"), 0.0);
  EXPECT_GT(along_theta("cyclic_high"), 0.0);
}

TEST(SectorMesher, TheSplitterStandsAtItsFractionOfThePitch) {
  const MeshedSector mesh = sector_from(test::with_keys(case_text("fast_impeller"), "splitter_pitch = 0.4\n"));
  const auto exit_angle = [&](const std::string& tip) {
    double sum = 0.0;
    int count = 0;
    for (const std::size_t node : mesh.surface(tip).face_nodes) {
      const Eigen::Vector3d& at = mesh.nodes[node];
      if (at.head<2>().norm() < 0.122 - 1e-9) continue;
      sum += std::atan2(at[1], at[0]);
      ++count;
    }
    return sum / count;
  };
  EXPECT_NEAR(exit_angle("splitter_tip") - exit_angle("blade_tip"), 0.4 * 2.0 * EIGEN_PI / 10.0, 1e-9);
}

TEST(SectorMesher, AWheelWithoutSplitterHasNone) {
  std::string text = with(case_text("fast_impeller"), "splitter_start", "0.45");
  text.replace(text.find("splitter_start = 0.45"), 21, "splitter = false");
  text.replace(text.find("elements_through_splitter = 2"), 29, "");
  const MeshedSector mesh = sector_from(text);
  for (const SectorCell& cell : mesh.cells) EXPECT_NE(cell.region, Region::splitter);
  EXPECT_EQ(test::complaint(text), "");
}

}  // namespace
}  // namespace tiprub::mesh
