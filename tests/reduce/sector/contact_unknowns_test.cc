// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/contact_unknowns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "tests/cases/complaint.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::contact_unknowns_test {
namespace {

constexpr double rounding = 1e-12;

/// A blade whose tip is part of a cylinder, wrapped, of even steps along the axis and uneven ones around.
SectorMesh blade(int bricks_along, int nodes_per_brick) {
  const test::BrickGrid grid({2, 2, bricks_along}, nodes_per_brick, test::Around::open);
  SectorMesh mesh = grid.place([](const Eigen::Vector3d& at) -> Eigen::Vector3d {
    const double theta = 3.1 + 0.05 * at[1] * at[1] + 0.4 * at[2], r = 0.1 + 0.05 * at[0];  // across theta = pi
    return {r * std::cos(theta), r * std::sin(theta), 0.09 * at[2]};
  });
  mesh.clamped = grid.layer(0, 0);
  for (int k = 0; k <= 2 * bricks_along; ++k) mesh.contact_line.push_back(grid.node(4, 2, k));
  mesh.tip_faces = grid.outer_faces(0, 2);
  return mesh;
}

constexpr double length = 0.09;  // [m] of the tip line

TEST(ContactSegments, MoveWithARigidBodyAsTheirCentresDo) {
  for (const int nodes_per_brick : {20, 27})
    for (const int count : {1, 2, 5, 9}) {
      const SectorMesh mesh = blade(8, nodes_per_brick);
      const ContactUnknowns contact = choose_contact(mesh, ContactKind::segments, count);
      const Eigen::Matrix3Xd tip = mesh.nodes(Eigen::all, contact.tip);
      ASSERT_EQ(contact.line.size(), count);
      // Of a translation along the axis, and of a turn about it, by r at the centre: forces and moments of a segment
      // are those of a force at its centre.
      EXPECT_LT((contact.weights.rowwise().sum().array() - 1).abs().maxCoeff(), rounding);
      const Eigen::VectorXd radius = tip.topRows<2>().colwise().norm();
      EXPECT_LT((contact.weights * radius - contact.line.position.col(0)).norm(), rounding);
      EXPECT_LT((contact.weights * tip.row(2).transpose() - contact.line.position.col(2)).norm(), rounding);
    }
}

TEST(ContactSegments, AddUpToTheWholeTip) {
  // Hats sum to one: all segments by their areas are the one segment that spreads over everything.
  const SectorMesh mesh = blade(8, 27);
  const ContactUnknowns five = choose_contact(mesh, ContactKind::segments, 5);
  const ContactUnknowns one = choose_contact(mesh, ContactKind::segments, 1);
  const Eigen::RowVector<double, 5> areas(0.125, 0.25, 0.25, 0.25, 0.125);
  EXPECT_LT((areas * five.weights - one.weights).norm(), 1e-6);  // the tip's area is even along the line
}

TEST(ContactSegments, StandAtTheCentresOfTheirHats) {
  // Knots at edges of faces: hats are integrated exactly. A whole hat's centre is its knot, half a one's is a third.
  const SectorMesh mesh = blade(8, 27);
  const ContactLine line = choose_contact(mesh, ContactKind::segments, 5).line;
  const double step = length / 4;
  const Eigen::Vector<double, 5> centres(step / 3, step, 2 * step, 3 * step, length - step / 3);
  EXPECT_LT((line.arc_length - centres).norm(), 1e-10 * length);
  EXPECT_LT((line.position.col(2) - centres).norm(), 1e-10 * length);
  EXPECT_LT((line.position.col(0).array() - 0.15).abs().maxCoeff(), 1e-5);  // quadratic faces of a cylinder
  // The middle of the thickness by area; theta runs across pi without a jump.
  for (Eigen::Index k = 0; k < 5; ++k)
    EXPECT_NEAR(line.position(k, 1), 3.1 + 0.025 + 0.4 * centres[k] / length, 1e-5);
  EXPECT_LT((line.normal - Eigen::RowVector3d(1, 0, 0).replicate(5, 1)).norm(), 1e-9);
}

/// Symptom: segments were limited by the nodes of the line, which may be fewer than those of the tip.
TEST(ContactSegments, MayBeMoreThanTheNodesOfTheLine) {
  SectorMesh mesh = blade(8, 20);
  mesh.contact_line = {mesh.contact_line.front(), mesh.contact_line[8], mesh.contact_line.back()};
  EXPECT_EQ(choose_contact(mesh, ContactKind::segments, 9).line.size(), 9);
  EXPECT_EQ(complaint<InputError>([&] { choose_contact(mesh, ContactKind::points, 9); }),
            mesh.file +
                ": the line \"contact\" has 3 nodes, [reduce] contact_nodes = 9 asks for more; ask for fewer, "
                "or refine the mesh along the blade");
}

/// Symptom: the arc lengths stopped at the ends of a line that is shorter than the tip, and the centres did not, so
/// that the model was refused.
TEST(ContactSegments, HaveArcLengthsOnWhereTheTipReachesFartherThanItsLine) {
  SectorMesh mesh = blade(8, 20);
  mesh.contact_line.erase(mesh.contact_line.begin());
  mesh.contact_line.resize(mesh.contact_line.size() - 2);
  const ContactLine line = choose_contact(mesh, ContactKind::segments, 5).line;
  const double first = mesh.nodes(2, mesh.contact_line.front());  // the tip runs straight along the axis
  EXPECT_LT((line.arc_length.array() + first - line.position.col(2).array()).matrix().norm(), 1e-10 * length);
}

TEST(ContactSegments, KeepTheirCentresOverTheMesh) {
  // Knots inside faces: the kinks are integrated by parts of a face.
  const ContactLine coarse = choose_contact(blade(9, 20), ContactKind::segments, 5).line;
  const ContactLine fine = choose_contact(blade(24, 20), ContactKind::segments, 5).line;
  EXPECT_LT((coarse.arc_length - fine.arc_length).cwiseAbs().maxCoeff(), 1e-3 * length / 4);
}

TEST(ContactSegments, SpreadOverTheTip) {
  const SectorMesh mesh = blade(8, 20);
  const ContactUnknowns contact = choose_contact(mesh, ContactKind::segments, 9);
  const std::set<int> tip(mesh.tip_faces.data(), mesh.tip_faces.data() + mesh.tip_faces.size());
  EXPECT_EQ(std::set<int>(contact.tip.begin(), contact.tip.end()), tip);
  // Each has a node of the line of its own beside its centre.
  EXPECT_EQ(std::set<int>(contact.nodes.begin(), contact.nodes.end()).size(), 9u);
  const SectorDofs dofs = number_dofs(mesh, contact);
  EXPECT_EQ(dofs.contact_dofs(), 27);
  EXPECT_EQ(dofs.boundary(), 0);
  for (Eigen::Index k = 0; k < 9; ++k)
    for (std::size_t i = 0; i < contact.tip.size(); ++i)
      EXPECT_EQ(dofs.contact_loads.coeff(dofs.first[contact.tip[i]] + 1, 3 * k + 1),
                contact.weights(k, static_cast<Eigen::Index>(i)));
}

TEST(ContactPoints, AreNodesOfTheLine) {
  const SectorMesh mesh = blade(8, 20);
  const ContactUnknowns contact = choose_contact(mesh, ContactKind::points, 5);
  EXPECT_EQ(contact.weights.size(), 0);
  EXPECT_EQ(contact.nodes, std::vector<int>({mesh.contact_line[0], mesh.contact_line[4], mesh.contact_line[8],
                                             mesh.contact_line[12], mesh.contact_line[16]}));
}

TEST(ContactUnknowns, AreSegmentsWhereAllTipsHaveNamesElsePoints) {
  const auto chosen = [](const SectorMesh& mesh, int count) {
    return choose_contact(mesh, std::nullopt, count).line;
  };
  const SectorMesh named = blade(8, 20);
  EXPECT_EQ(chosen(named, 5).kind, ContactKind::segments);
  EXPECT_EQ(chosen(named, 5).position, choose_contact(named, ContactKind::segments, 5).line.position);
  SectorMesh unnamed = named;
  unnamed.tip_faces.resize(8, 0);
  EXPECT_EQ(chosen(unnamed, 5).kind, ContactKind::points);
  SectorMesh one_node = named;
  one_node.contact_line.resize(1);
  EXPECT_EQ(chosen(one_node, 1).kind, ContactKind::points);
  SectorMesh splitter = named;
  splitter.splitter_line = named.contact_line;
  EXPECT_EQ(chosen(splitter, 5).kind, ContactKind::points);
  splitter.splitter_faces = named.tip_faces;
  EXPECT_EQ(chosen(splitter, 5).kind, ContactKind::segments);
}

std::string refusal(const SectorMesh& mesh, int count = 5) {
  return complaint<InputError>([&] { choose_contact(mesh, ContactKind::segments, count); });
}

TEST(ContactSegments, RefuseAMeshThatDoesNotNameTheTip) {
  SectorMesh mesh = blade(8, 20);
  mesh.tip_faces.resize(8, 0);
  EXPECT_EQ(
      refusal(mesh),
      "the sector: has no surface group \"blade_tip\" with the faces of the main blade's tip (of the cells' own "
      "kind), over which [reduce] contact = \"segments\" spreads its forces; name it in the mesher, or take "
      "\"points\"");
}

TEST(ContactSegments, RefuseASplitterWhoseTipHasNoName) {
  SectorMesh mesh = blade(8, 20);
  mesh.splitter_line = mesh.contact_line;
  EXPECT_EQ(
      refusal(mesh),
      "the sector: has no surface group \"splitter_tip\" with the faces of the splitter's tip (of the cells' own "
      "kind), over which [reduce] contact = \"segments\" spreads its forces; name it in the mesher, or take "
      "\"points\"");
}

TEST(ContactSegments, RefuseATipWithAGap) {
  SectorMesh mesh = blade(8, 20);
  mesh.tip_faces.conservativeResize(Eigen::NoChange, 8);  // half of the length
  EXPECT_EQ(refusal(mesh),
            "the sector: the faces of the surface group \"blade_tip\" leave out a stretch of the line \"contact\", "
            "segment 4 of 5; it must hold all of the main blade's tip, and no other surface");
}

TEST(ContactSegments, RefuseMoreThanTheTipCanTellApart) {
  const std::string many = refusal(blade(8, 20), 18);
  EXPECT_NE(many.find("contact_nodes = 18 asks for more"), std::string::npos) << many;
  // One face over the whole tip, beside a finer line.
  SectorMesh coarse = blade(8, 20);
  const test::BrickGrid grid({2, 2, 8}, 20, test::Around::open);
  const auto node = [&](int around, int along) { return grid.node(4, around, along); };
  coarse.tip_faces = Eigen::Vector<int, 8>(node(0, 0), node(4, 0), node(4, 16), node(0, 16), node(2, 0), node(4, 8),
                                           node(2, 16), node(0, 8));
  EXPECT_EQ(refusal(coarse, 3), "");
  EXPECT_EQ(refusal(coarse, 9),
            "the sector: [reduce] contact_nodes = 9 asks for more segments than the 8 nodes of the main blade's tip "
            "can tell apart; ask for fewer, or refine the mesh along the blade");
}

TEST(ContactSegments, RefuseALineOfOneNode) {
  SectorMesh mesh = blade(8, 20);
  mesh.contact_line.resize(1);
  EXPECT_NE(refusal(mesh, 1).find("the line \"contact\" has one node"), std::string::npos);
}

std::string complaint(const SectorMesh& mesh, int count) {
  return tiprub::complaint<InputError>([&] { choose_contact(mesh, ContactKind::segments, count); });
}

TEST(ContactSegments, AreRefusedOnFlanks) {
  SectorMesh mesh = blade(8, 20);
  const test::BrickGrid grid({2, 2, 8}, 20, test::Around::open);
  Eigen::VectorXi flank(8);
  flank << grid.node(2, 0, 0), grid.node(4, 0, 0), grid.node(4, 0, 2), grid.node(2, 0, 2), grid.node(3, 0, 0),
      grid.node(4, 0, 1), grid.node(3, 0, 2), grid.node(2, 0, 1);
  mesh.tip_faces.conservativeResize(Eigen::NoChange, mesh.tip_faces.cols() + 1);
  mesh.tip_faces.rightCols(1) = flank;
  EXPECT_NE(complaint(mesh, 5).find(" of the surface group \"blade_tip\" does not face the casing, "),
            std::string::npos)
      << complaint(mesh, 5);
}

TEST(ContactSegments, AreRefusedBesideALineThatLeavesOutAPart) {
  SectorMesh mesh = blade(8, 20);
  mesh.contact_line.resize(9);  // of 17
  EXPECT_NE(complaint(mesh, 5).find("of which 50 % lie beyond its ends"), std::string::npos) << complaint(mesh, 5);
}

TEST(ContactSegments, AreRefusedBesideALineElsewhere) {
  SectorMesh mesh = blade(8, 20);
  const test::BrickGrid grid({2, 2, 8}, 20, test::Around::open);
  for (std::size_t k = 0; k < mesh.contact_line.size(); ++k)
    mesh.contact_line[k] = grid.node(0, 2, static_cast<int>(k));  // at the root
  EXPECT_NE(complaint(mesh, 5).find(" of the line \"contact\" is not on the surface group \"blade_tip\""),
            std::string::npos)
      << complaint(mesh, 5);
}

TEST(ContactSegments, AreAtMostAsManyAsNodes) {
  EXPECT_NE(complaint(blade(2, 20), 200).find("asks for more segments than the "), std::string::npos);
}

}  // namespace
}  // namespace tiprub::reduce::contact_unknowns_test
