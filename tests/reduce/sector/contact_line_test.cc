// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/contact_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/cases/complaint.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

/// A blade whose tip runs along a quarter circle from axial to radial, as an impeller's under its shroud: the circle
/// stands at radius 0.12, the blade reaches from its distance 0.08 down to the tip at 0.05. Steps along the chord
/// grow and the blade wraps, which no normal may notice.
SectorMesh quarter_circle_blade(int bricks_along_chord, double height = 0.03) {
  const test::BrickGrid grid({2, 1, bricks_along_chord}, 20, test::Around::open);
  SectorMesh mesh = grid.place([height](const Eigen::Vector3d& at) -> Eigen::Vector3d {
    const double phi = std::numbers::pi / 2 * (0.7 * at[2] + 0.3 * at[2] * at[2]);
    const double distance = 0.05 + height * (1.0 - at[0]), theta = 0.02 * at[1] + 0.5 * at[2];
    const double r = 0.12 - distance * std::cos(phi);
    return {r * std::cos(theta), r * std::sin(theta), distance * std::sin(phi)};
  });
  for (int k = 0; k <= 2 * bricks_along_chord; ++k) mesh.contact_line.push_back(grid.node(4, 0, k));
  return mesh;
}

/// The same with a splitter: the other side of the tip, from the middle of the chord on.
SectorMesh with_splitter(int bricks_along_chord) {
  const test::BrickGrid grid({2, 1, bricks_along_chord}, 20, test::Around::open);
  SectorMesh mesh = quarter_circle_blade(bricks_along_chord);
  for (int k = bricks_along_chord; k <= 2 * bricks_along_chord; ++k) mesh.splitter_line.push_back(grid.node(4, 2, k));
  return mesh;
}

constexpr double tip_distance = 0.05;  // [m] of the tip from the circle's middle

double polar_angle(const ContactLine& line, Eigen::Index node) {
  return std::atan2(line.position(node, 2), 0.12 - line.position(node, 0));
}

/// Largest distance of the normals from those of the circle, which point to its middle.
double normal_error(int bricks_along_chord) {
  const SectorMesh mesh = quarter_circle_blade(bricks_along_chord);
  const ContactLine line = describe_contact(mesh, mesh.contact_line);
  double worst = 0;
  for (Eigen::Index k = 0; k < line.size(); ++k) {
    const double phi = polar_angle(line, k);
    const Eigen::RowVector3d exact(std::cos(phi), 0.0, -std::sin(phi));
    worst = std::max(worst, (line.normal.row(k) - exact).norm());
  }
  return worst;
}

TEST(ContactLine, NormalsOfAQuarterCircleConvergeToIt) {
  const double coarse = normal_error(8), fine = normal_error(16);
  EXPECT_LT(fine, 1e-3);
  EXPECT_GT(std::log2(coarse / fine), 1.8);
}

TEST(ContactLine, HasTheCurvatureOfAQuarterCircle) {
  // The shroud bends away from the blade, whose tip therefore leaves it along the tangent.
  const SectorMesh mesh = quarter_circle_blade(16);
  const ContactLine line = describe_contact(mesh, mesh.contact_line);
  const Eigen::VectorXd curvature = meridional_curvature(mesh, mesh.contact_line, line.normal);
  for (const double of_node : curvature) EXPECT_NEAR(of_node * tip_distance, -1.0, 0.02);
  SectorMesh edge = mesh;
  edge.contact_line = {mesh.contact_line.front(), mesh.contact_line.back()};
  EXPECT_TRUE(meridional_curvature(edge, edge.contact_line, line.normal.topRows(2)).isZero(0.0));
}

TEST(ContactLine, NormalsLeaveABladeOfFlatBricksToo) {
  // With fine layers at the tip some normals pointed into the blade: along a tip that bends towards the casing the
  // neighbours lie on the casing's side, by more than such a brick is high.
  const SectorMesh mesh = quarter_circle_blade(4, 0.002);
  const ContactLine line = describe_contact(mesh, mesh.contact_line);
  for (Eigen::Index k = 0; k < line.size(); ++k) {
    const double phi = polar_angle(line, k);
    EXPECT_GT(line.normal.row(k).dot(Eigen::RowVector3d(std::cos(phi), 0.0, -std::sin(phi))), 0.9) << k;
  }
}

TEST(ContactLine, NormalsAreOfUnitLengthAndStayInTheMeridionalPlane) {
  const SectorMesh mesh = quarter_circle_blade(6);
  const ContactLine line = describe_contact(mesh, mesh.contact_line);
  for (Eigen::Index k = 0; k < line.size(); ++k) {
    EXPECT_NEAR(line.normal.row(k).norm(), 1.0, 1e-14);
    EXPECT_EQ(line.normal(k, 1), 0.0);
  }
}

TEST(ContactLine, TellsPlacesInCylindricalCoordinates) {
  const SectorMesh mesh = quarter_circle_blade(6);
  const ContactLine line = describe_contact(mesh, mesh.contact_line);
  for (Eigen::Index k = 0; k < line.size(); ++k) {
    const double r = line.position(k, 0), theta = line.position(k, 1);
    const Eigen::Vector3d back(r * std::cos(theta), r * std::sin(theta), line.position(k, 2));
    EXPECT_LT((back - mesh.nodes.col(mesh.contact_line[k])).norm(), 1e-15);
  }
  EXPECT_EQ(line.arc_length[0], 0.0);
  const double quarter = std::numbers::pi / 2 * tip_distance;
  EXPECT_LT(line.arc_length[line.size() - 1], quarter);  // chords are shorter than their arcs
  EXPECT_NEAR(line.arc_length[line.size() - 1] / quarter, 1.0, 1e-3);
  EXPECT_EQ(line.static_shift(1000.0), Eigen::MatrixX3d::Zero(line.size(), 3));
}

TEST(ContactLine, StraightLinesHaveOneNormal) {
  // The rim of an annulus: radial, outward. Three nodes only.
  const SectorMesh mesh = test::Annulus().sector();
  const ContactLine line = describe_contact(mesh, mesh.contact_line);
  for (Eigen::Index k = 0; k < 3; ++k) EXPECT_LT((line.normal.row(k) - Eigen::RowVector3d(1, 0, 0)).norm(), 1e-14);
}

TEST(ContactLine, ChosenNodesIncludeTheEndsAndKeepTheirOrder) {
  const SectorMesh mesh = quarter_circle_blade(10);
  for (const int count : {2, 3, 7, 10, 21}) {
    const std::vector<int> chosen = choose_contact_nodes(mesh, count);
    ASSERT_EQ(static_cast<int>(chosen.size()), count);
    EXPECT_EQ(chosen.front(), mesh.contact_line.front());
    EXPECT_EQ(chosen.back(), mesh.contact_line.back());
    const ContactLine line = describe_contact(mesh, chosen);
    for (int k = 1; k < count; ++k) EXPECT_GT(line.arc_length[k], line.arc_length[k - 1]);
  }
  EXPECT_EQ(choose_contact_nodes(mesh, 21), mesh.contact_line);
}

TEST(ContactLine, ChosenNodesStandNearestToEqualSteps) {
  const SectorMesh mesh = quarter_circle_blade(20);
  const ContactLine all = describe_contact(mesh, mesh.contact_line);
  const ContactLine line = describe_contact(mesh, choose_contact_nodes(mesh, 6));
  for (int k = 0; k < 6; ++k) {
    const double target = all.arc_length[all.size() - 1] * k / 5;
    EXPECT_EQ(std::abs(line.arc_length[k] - target), (all.arc_length.array() - target).abs().minCoeff());
  }
}

TEST(ContactLine, ASingleNodeIsTheLeadingEdge) {
  const SectorMesh mesh = quarter_circle_blade(4);
  EXPECT_EQ(choose_contact_nodes(mesh, 1), std::vector<int>{mesh.contact_line.front()});
}

TEST(ContactLine, RefusesMoreNodesThanTheLineHas) {
  const SectorMesh mesh = quarter_circle_blade(4);
  EXPECT_EQ(complaint<InputError>([&] { choose_contact_nodes(mesh, 10); }),
            "the sector: the line \"contact\" has 9 nodes, [reduce] contact_nodes = 10 asks for more; ask for fewer, "
            "or refine "
            "the mesh along the blade");
}

TEST(ContactLine, MayBendButNotTurnBackOrStandStill) {
  // Points out of order, with arc lengths of more than the whole tip, were accepted.
  SectorMesh mesh = quarter_circle_blade(4);
  EXPECT_NO_THROW(require_one_way(mesh));
  std::swap(mesh.contact_line[3], mesh.contact_line[6]);
  const std::string message = complaint<InputError>([&] { require_one_way(mesh); });
  EXPECT_EQ(message.rfind("the sector: the line \"contact\" turns back at its point 4 of 9, " +
                              mesh.place_of(mesh.contact_line[3]) + "; it must run once",
                          0),
            0u)
      << message;
  mesh = quarter_circle_blade(4);
  mesh.contact_line = {mesh.contact_line[4], mesh.contact_line[0], mesh.contact_line[8]};
  EXPECT_NE(complaint<InputError>([&] { require_one_way(mesh); }), "");
  mesh.contact_line = {mesh.contact_line[0], mesh.contact_line[0]};
  EXPECT_NE(complaint<InputError>([&] { require_one_way(mesh); }).find("the same radius and z at its point 2"),
            std::string::npos);
}

TEST(ContactLine, OfASplitterFollowsTheMainBladesBelowOneCasing) {
  const SectorMesh mesh = with_splitter(8);
  EXPECT_NO_THROW(require_one_way(mesh));
  const std::vector<int> chosen = choose_contact_nodes(mesh, 9);
  ASSERT_EQ(chosen.size(), 18U);
  const ContactLine line = describe_contact(mesh, chosen);
  EXPECT_EQ(line.splitter_nodes, 9);
  EXPECT_EQ(line.trailing_edge(), 8);
  const ContactLine main = describe_contact(mesh, mesh.contact_line);
  for (int k = 0; k < 9; ++k) {  // its node k stands beside node 8 + k of the whole line, 0.02 rad further round
    EXPECT_NEAR(line.arc_length[9 + k], main.arc_length[8 + k], 1e-15);
    EXPECT_NEAR(line.position(9 + k, 1), main.position(8 + k, 1) + 0.02, 1e-15);
    EXPECT_NEAR((line.normal.row(9 + k) - main.normal.row(8 + k)).norm(), 0.0, k == 0 ? 1e-2 : 1e-12);  // one-sided
  }
  EXPECT_EQ(line.place_of(0), "leading edge");
  EXPECT_EQ(line.place_of(4), "");
  EXPECT_EQ(line.place_of(8), "trailing edge");
  EXPECT_EQ(line.place_of(9), "splitter's leading edge");
  EXPECT_EQ(line.place_of(12), "splitter");
  EXPECT_EQ(line.place_of(17), "splitter's trailing edge");
}

TEST(ContactLine, OfASplitterThatRunsBackIsRefused) {
  SectorMesh mesh = with_splitter(8);
  std::reverse(mesh.splitter_line.begin(), mesh.splitter_line.end());
  EXPECT_EQ(complaint<InputError>([&] { describe_contact(mesh, choose_contact_nodes(mesh, 3)); }),
            "the sector: the line \"contact_splitter\" doesn't go on along the line \"contact\" at " +
                mesh.place_of(choose_contact_nodes(mesh, 3)[4]) +
                "; both must run from leading to trailing edge, below one casing");
  EXPECT_NE(
      complaint<InputError>([&] { choose_contact_nodes(mesh, 10); }).find("the line \"contact_splitter\" has 9"),
      std::string::npos);
}

}  // namespace
}  // namespace tiprub::reduce
