// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mesh/mesh_cases.h"
#include "tests/mesh/sector_geometry.h"

namespace tiprub::mesh::sector_check_test {
namespace {

using test::case_text;
using test::complaint;
using test::with;

SectorReport report_of(const std::string& text) {
  const Wheel wheel = test::wheel_from(text);
  return measure_sector(mesh_sector(wheel), wheel);
}

struct Cases {
  const char *coarse, *fine;
  double exit_radius;
  std::size_t coarse_dofs_min, coarse_dofs_max;
  double same_volume;  // an integral from station to station, over tables that bend there or between
};
constexpr Cases all_cases[] = {{"impeller_quick", "impeller", 0.2155, 12000, 13000, 3e-7},
                               {"fast_impeller", "fast_impeller_fine", 0.122, 7000, 9000, 1e-7}};

/// The case without its fillets: on these, elements at the hub are as flat as the fillet's foot (RootFillet).
std::string without_fillets(const char* name) {
  const std::string text = case_text(name);
  return text.find("\nfillet_radius") == std::string::npos ? text : with(text, "fillet_radius", "0.0");
}

void expect_promises(const char* name, double exit_radius) {
  const Wheel wheel = test::wheel_from(without_fillets(name));
  const MeshedSector mesh = mesh_sector(wheel);
  const SectorReport report = measure_sector(mesh, wheel);
  const std::vector<Eigen::Vector3d> normals = test::contact_normals(mesh);
  EXPECT_GT(report.worst_scaled_jacobian, 0.25) << name;  // a brick is fit for use above 0.2
  EXPECT_LT(test::pairing_mismatch(mesh), 1e-12 * report.largest_radius) << name;
  EXPECT_NEAR(report.mesh_volume / test::geometry_volume(wheel), 1.0, 3e-5) << name;
  EXPECT_NEAR(test::angle_from_radial_deg(normals.front(), mesh.nodes[mesh.contact.front()]), 0.0, 0.5) << name;
  EXPECT_NEAR(test::angle_from_radial_deg(normals.back(), mesh.nodes[mesh.contact.back()]), 90.0, 0.5) << name;
  EXPECT_DOUBLE_EQ(report.largest_radius, exit_radius) << name;
  EXPECT_NEAR(report.smallest_radius, 0.028, 1e-15) << name;
}

TEST(SectorCheck, AllImpellersKeepTheirPromises) {
  for (const Cases& cases : all_cases) {
    expect_promises(cases.coarse, cases.exit_radius);
    expect_promises(cases.fine, cases.exit_radius);
  }
}

TEST(SectorCheck, AllImpellersHaveTheSizeThatIsSaid) {
  for (const Cases& cases : all_cases) {
    const std::size_t coarse = 3 * test::sector_from(case_text(cases.coarse)).nodes.size();
    const std::size_t fine = 3 * test::sector_from(case_text(cases.fine)).nodes.size();
    EXPECT_GE(coarse, cases.coarse_dofs_min);
    EXPECT_LE(coarse, cases.coarse_dofs_max);
    EXPECT_GE(fine, 110000u);
    EXPECT_LE(fine, 130000u);
  }
}

TEST(SectorCheck, CoarseAndFineAreTheSameWheel) {
  for (const Cases& cases : all_cases)
    EXPECT_NEAR(test::geometry_volume(test::wheel_from(without_fillets(cases.fine))) /
                    test::geometry_volume(test::wheel_from(without_fillets(cases.coarse))),
                1.0, cases.same_volume);
}

TEST(SectorCheck, ContactNormalsTurnSteadilyByNinetyDegrees) {
  const MeshedSector mesh = test::sector_from(case_text("fast_impeller"));
  const std::vector<Eigen::Vector3d> normals = test::contact_normals(mesh);
  ASSERT_EQ(normals.size(), mesh.contact.size());
  for (std::size_t n = 1; n < normals.size(); ++n) EXPECT_LT(normals[n][2], normals[n - 1][2]);
}

TEST(SectorCheck, CountsClampedNodes) {
  const MeshedSector mesh = test::sector_from(test::annular_plate(4));
  EXPECT_EQ(report_of(test::annular_plate(4)).clamped_nodes, 23u);  // 5 x 2 corners and 13 mid-sides of 4 x 1 faces
  const std::set<std::size_t> clamped = test::nodes_on(mesh, "clamped");
  for (const char* cut : {"cyclic_low", "cyclic_high"}) {
    const std::set<std::size_t> nodes = test::nodes_on(mesh, cut);
    EXPECT_EQ(std::ranges::count_if(nodes, [&](std::size_t node) { return clamped.contains(node); }), 3);
  }
}

TEST(SectorCheck, TwistedBladesAreMeshedToTheirVolume) {
  const Wheel wheel = test::wheel_from(test::twisted_blades());
  const SectorReport report = measure_sector(mesh_sector(wheel), wheel);
  EXPECT_GT(report.worst_scaled_jacobian, 0.4);
  EXPECT_NEAR(report.mesh_volume / test::geometry_volume(wheel), 1.0, 1e-4);
}

TEST(SectorCheck, RefusesAnInvertedElementAndNamesWhatShapesIt) {
  // The back face cuts through the hub.
  const std::string broken =
      with(case_text("fast_impeller"), "back_profile", "[[0.028, 0.092], [0.09, 0.04], [0.122, 0.0705]]");
  const std::string message = complaint(broken);
  EXPECT_NE(message.find("inverted element in the disc"), std::string::npos) << message;
  EXPECT_NE(message.find("station"), std::string::npos) << message;
  EXPECT_NE(message.find("look at [mesh] back_profile"), std::string::npos) << message;
}

}  // namespace
}  // namespace tiprub::mesh::sector_check_test
