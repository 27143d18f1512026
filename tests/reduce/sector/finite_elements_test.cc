// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/finite_elements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "tests/cases/complaint.h"
#include "tests/reduce/split_cells.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::Annulus;

Eigen::Matrix3d parallelepiped() {
  Eigen::Matrix3d edges;
  edges << 0.3, 0.1, 0.0, -0.1, 0.4, 0.05, 0.02, 0.1, 0.2;
  return edges;
}

/// A parallelepiped: straight bricks, on which the map is affine.
SectorMesh straight_bricks(int nodes_per_brick) {
  return test::BrickGrid({2, 1, 2}, nodes_per_brick, test::Around::open)
      .place([](const Eigen::Vector3d& at) -> Eigen::Vector3d {
        return Eigen::Vector3d(1, 0, 0) + parallelepiped() * at;
      });
}

class BothBricks : public ::testing::TestWithParam<int> {
 protected:
  SectorMesh skewed_sector() const {
    Annulus annulus = test::skewed_annulus(5);
    annulus.nodes_per_brick = GetParam();
    return annulus.sector();
  }
};
INSTANTIATE_TEST_SUITE_P(Nodes, BothBricks, ::testing::Values(20, 27));

/// All kinds of cells: bricks of 27 nodes, and what they are split into.
class EveryKind : public ::testing::TestWithParam<std::optional<test::Split>> {
 protected:
  SectorMesh skewed_sector() const {
    Annulus annulus = test::skewed_annulus(5);
    annulus.nodes_per_brick = 27;
    return split(annulus.sector());
  }
  SectorMesh straight_cells() const { return split(straight_bricks(27)); }

 private:
  static SectorMesh split(const SectorMesh& bricks) { return GetParam() ? test::split(bricks, *GetParam()) : bricks; }
};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryKind,
                         ::testing::Values(std::nullopt, test::Split::tet10, test::Split::wedge15,
                                           test::Split::pyramid13, test::Split::hex20, test::Split::mixed,
                                           test::Split::bricks_and_wedges));

/// Largest errors over all points of a field known in space: sum N_a f(x_a) = f(x), sum grad N_a f(x_a) = grad f(x).
template <class Field, class Gradient>
void expect_reproduced(const SectorMesh& mesh, const Field& f, const Gradient& grad_f) {
  FiniteElements(mesh).visit([&](const CellPoints& points) {
    Eigen::VectorXd nodal(points.nodes.size());
    for (std::size_t a = 0; a < points.nodes.size(); ++a)
      nodal[a] = f(Eigen::Vector3d(mesh.nodes.col(points.nodes[a])));
    for (Eigen::Index q = 0; q < points.weight.size(); ++q) {
      const Eigen::Vector3d at = points.position.col(q);
      EXPECT_NEAR(points.shape.col(q).dot(nodal), f(at), 1e-13);
      EXPECT_LT((points.gradient[q].transpose() * nodal - grad_f(at)).norm(), 1e-11);
    }
  });
}

double volume_of(const SectorMesh& mesh) {
  double volume = 0;
  FiniteElements(mesh).visit([&](const CellPoints& points) { volume += points.weight.sum(); });
  return volume;
}

TEST_P(EveryKind, AreAPartitionOfUnity) {
  expect_reproduced(
      skewed_sector(), [](const Eigen::Vector3d&) { return 1.0; },
      [](const Eigen::Vector3d&) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); });
}

TEST_P(EveryKind, ReproduceLinearFieldsOnCurvedCells) {
  const Eigen::Vector3d slope(1.0, -2.0, 3.0);
  expect_reproduced(
      skewed_sector(), [=](const Eigen::Vector3d& x) { return slope.dot(x); },
      [=](const Eigen::Vector3d&) { return slope; });
}

TEST_P(EveryKind, ReproduceQuadraticFieldsOnStraightCells) {
  Eigen::Matrix3d form;
  form << 1, 2, -1, 2, 3, 0.5, -1, 0.5, -2;
  expect_reproduced(
      straight_cells(), [=](const Eigen::Vector3d& x) { return x.dot(form * x); },
      [=](const Eigen::Vector3d& x) -> Eigen::Vector3d { return 2 * form * x; });
}

TEST_P(EveryKind, FillAParallelepiped) {
  EXPECT_NEAR(volume_of(straight_cells()), parallelepiped().determinant(), 1e-15);
}

TEST_P(BothBricks, FillAnAnnulusWithTheFourthOrder) {
  // Volume of a sector, (b^2 - a^2) h pi / N; arcs are parabolas through three points.
  Annulus annulus;
  annulus.nodes_per_brick = GetParam();
  const double exact = std::numbers::pi / annulus.sector_count * annulus.height *
                       (annulus.outer * annulus.outer - annulus.inner * annulus.inner);
  double errors[2];
  for (int refined : {0, 1}) {
    annulus.bricks[1] = refined == 0 ? 2 : 4;
    errors[refined] = std::abs(volume_of(annulus.sector()) / exact - 1);
  }
  EXPECT_LT(errors[1], 3e-5);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4.0, 0.1);
}

TEST_P(BothBricks, RefuseAnInvertedCellWithItsNumberAndPlace) {
  SectorMesh mesh = skewed_sector();
  mesh.nodes.col(mesh.cells(0, 3)) = mesh.nodes.col(mesh.cells(6, 3));  // a corner pushed through its brick
  const std::string message = complaint<InputError>([&] { FiniteElements elements(mesh); });
  EXPECT_EQ(message.rfind("the sector: cell ", 0), 0u) << message;
  EXPECT_NE(message.find("is inverted or flat near x y z = "), std::string::npos) << message;
}

TEST_P(BothBricks, RefuseACellThatIsInvertedAtACornerOnly) {
  // A mid-side node less than a quarter of its edge away from a corner turns the brick inside out there, beyond the
  // last Gauss point. Such sectors were reduced without a word.
  SectorMesh mesh = straight_bricks(GetParam());
  mesh.parts["main_blade"] = {1};
  mesh.cell_tags = {11, 12, 13, 14};
  const Eigen::Vector3d corner = mesh.nodes.col(mesh.cells(1, 1)), other = mesh.nodes.col(mesh.cells(0, 1));
  mesh.nodes.col(mesh.cells(8, 1)) = 0.8 * corner + 0.2 * other;
  EXPECT_EQ(complaint<InputError>([&] { FiniteElements elements(mesh); }),
            "the sector: cell 12 (main_blade) is inverted or flat near " + place_text(corner) + "; re-mesh");
}

TEST_P(BothBricks, RefuseAMirroredMesh) {
  SectorMesh mesh = skewed_sector();
  mesh.nodes.row(2) *= -1;
  EXPECT_NE(complaint<InputError>([&] { FiniteElements elements(mesh); }), "");
}

TEST(FiniteElements, RefusesNeighboursThatDisagreeAboutAMidSide) {
  // A mesh with a double node in the middle of a shared edge was reduced without a word: the last brick read won, and
  // the other brick followed a node that none of its own names. It must be refused.
  SectorMesh mesh = Annulus().sector();
  const int shared = mesh.cells(9, 0);  // between corners 1 and 2, on the face to the next brick outwards
  mesh.nodes.conservativeResize(Eigen::NoChange, mesh.node_count() + 1);
  mesh.nodes.rightCols(1) = mesh.nodes.col(shared);
  mesh.cells(9, 0) = mesh.node_count() - 1;
  EXPECT_NE(complaint<InputError>([&] { FiniteElements elements(mesh); }).find("mid-side"), std::string::npos);
}

TEST(FiniteElements, RefusesQuadranglesThatMeetTriangles) {
  // Bricks and tetrahedra side by side without pyramids share corners, and come apart between them.
  const SectorMesh bricks = test::BrickGrid({2, 1, 1}, 27, test::Around::open).place([](const Eigen::Vector3d& at) {
    return Eigen::Vector3d(1 + at[0], at[1], at[2]);
  });
  SectorMesh mesh = test::split(bricks, test::Split::tet10);
  const SectorMesh whole = test::split(bricks, test::Split::hex20);
  Eigen::MatrixXi cells = Eigen::MatrixXi::Constant(20, 7, -1);
  cells.topLeftCorner(10, 6) = mesh.cells.leftCols(6);
  for (int k = 0; k < 20; ++k)
    for (int node = 0; node < mesh.node_count(); ++node)
      if ((mesh.nodes.col(node) - whole.nodes.col(whole.cells(k, 1))).norm() < 1e-9) cells(k, 6) = node;
  mesh.cells = cells;
  EXPECT_EQ(complaint<InputError>([&] {
              FiniteElements elements(mesh);
            }).rfind("the sector: the cells don't make a mesh: a quadrangle meets triangles at x y z = ", 0),
            0u);
}

}  // namespace
}  // namespace tiprub::reduce
