// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_check.h"

#include <gtest/gtest.h>

#include "tests/mesh/mesh_cases.h"

namespace tiprub {
namespace {

using test::case_text;
using test::complaint;
using test::with;

SectorReport report_of(const std::string& text) {
  const Wheel wheel = test::wheel_from(text);
  return measure_sector(mesh_sector(wheel), wheel);
}

TEST(SectorCheck, BothImpellersKeepTheirPromises) {
  for (const char* name : {"impeller_quick", "impeller"}) {
    const SectorReport report = report_of(case_text(name));
    EXPECT_GT(report.worst_scaled_jacobian, 0.25) << name;  // a brick is fit for use above 0.2
    EXPECT_LT(report.pairing_mismatch, 1e-12) << name;
    EXPECT_NEAR(report.mesh_volume / report.geometry_volume, 1.0, 3e-5) << name;
    EXPECT_NEAR(report.normal_angle_leading_deg, 0.0, 0.5) << name;
    EXPECT_NEAR(report.normal_angle_trailing_deg, 90.0, 0.5) << name;
    EXPECT_DOUBLE_EQ(report.largest_radius, 0.122) << name;
    EXPECT_NEAR(report.smallest_radius, 0.028, 1e-15) << name;
  }
}

TEST(SectorCheck, BothImpellersHaveTheSizeThatIsSaid) {
  const std::size_t quick = 3 * test::sector_from(case_text("impeller_quick")).nodes.size();
  const std::size_t full = 3 * test::sector_from(case_text("impeller")).nodes.size();
  EXPECT_GE(quick, 7000u);
  EXPECT_LE(quick, 9000u);
  EXPECT_GE(full, 110000u);
  EXPECT_LE(full, 130000u);
}

TEST(SectorCheck, BothImpellersAreTheSameWheel) {
  const double quick = report_of(case_text("impeller_quick")).geometry_volume;
  EXPECT_NEAR(report_of(case_text("impeller")).geometry_volume / quick, 1.0, 1e-7);
}

TEST(SectorCheck, ContactNormalsTurnSteadilyByNinetyDegrees) {
  const MeshedSector mesh = test::sector_from(case_text("impeller_quick"));
  const std::vector<Eigen::Vector3d> normals = contact_normals(mesh);
  ASSERT_EQ(normals.size(), mesh.contact.size());
  for (std::size_t n = 1; n < normals.size(); ++n) EXPECT_LT(normals[n][2], normals[n - 1][2]);
}

TEST(SectorCheck, CountsClampedNodesOnCyclicFaces) {
  const SectorReport report = report_of(test::annular_plate(4));
  EXPECT_EQ(report.clamped_nodes, 23u);        // 5 x 2 corners and 13 mid-sides of 4 x 1 faces
  EXPECT_EQ(report.clamped_cyclic_nodes, 6u);  // three on either cut
}

TEST(SectorCheck, TwistedBladesAreMeshedToTheirVolume) {
  const SectorReport report = report_of(test::twisted_blades());
  EXPECT_GT(report.worst_scaled_jacobian, 0.4);
  EXPECT_NEAR(report.mesh_volume / report.geometry_volume, 1.0, 1e-4);
}

TEST(SectorCheck, RefusesAnInvertedElementAndNamesWhatShapesIt) {
  // The back face cuts through the hub.
  const std::string broken =
      with(case_text("impeller_quick"), "back_profile", "[[0.028, 0.092], [0.09, 0.04], [0.122, 0.0705]]");
  const std::string message = complaint(broken);
  EXPECT_NE(message.find("inverted element in the disc"), std::string::npos) << message;
  EXPECT_NE(message.find("station"), std::string::npos) << message;
  EXPECT_NE(message.find("look at [mesh] back_profile"), std::string::npos) << message;
}

}  // namespace
}  // namespace tiprub
