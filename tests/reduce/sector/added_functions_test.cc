// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/added_functions.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/cells/cell_kind.h"
#include "reduce/sector/contact_unknowns.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/split_cells.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

struct Cells {
  const char* name;
  int nodes_per_brick;
  std::optional<test::Split> split;
};

/// A block of straight cells away from the axis, whose surface is held.
SectorMesh block(const Cells& cells) {
  constexpr int bricks = 3;
  const int layers = cells.split == test::Split::bricks_and_wedges ? 1 : bricks;  // no triangle below a quadrangle
  const test::BrickGrid grid({bricks, bricks, layers}, cells.nodes_per_brick, test::Around::open);
  SectorMesh mesh = grid.place(
      [](const Eigen::Vector3d& at) { return Eigen::Vector3d(0.2 + 0.1 * at[0], 0.12 * at[1], 0.07 * at[2]); });
  std::set<int> surface;
  for (int direction = 0; direction < 3; ++direction)
    for (const int step : {0, 2 * (direction == 2 ? layers : bricks)})
      for (const int node : grid.layer(direction, step)) surface.insert(node);
  mesh.clamped.assign(surface.begin(), surface.end());
  mesh.sector_count = 1;
  if (cells.split) return test::split(mesh, *cells.split);
  for (int cell = 0; cell < mesh.cell_count(); ++cell) test::turn_axes(mesh, cell, cell % 4);
  return mesh;
}

class AddedToEveryCell : public testing::TestWithParam<Cells> {};
INSTANTIATE_TEST_SUITE_P(Kinds, AddedToEveryCell,
                         testing::Values(Cells{"hex20", 20, {}}, Cells{"hex27", 27, {}},
                                         Cells{"tet10", 27, test::Split::tet10},
                                         Cells{"wedge15", 27, test::Split::wedge15},
                                         Cells{"pyramid13", 27, test::Split::pyramid13},
                                         Cells{"bricks_and_pyramids", 27, test::Split::mixed},
                                         Cells{"bricks_and_wedges", 27, test::Split::bricks_and_wedges}),
                         [](const auto& given) { return given.param.name; });

/// Quadratic displacements with a constant divergence of the stress are in equilibrium with a constant load. Every
/// function that vanishes on the surface does no work then, if it is one function in all cells around it.
TEST_P(AddedToEveryCell, DoNoWorkInEquilibrium) {
  const SectorMesh mesh = block(GetParam());
  ASSERT_TRUE(AddedFunctions::serve(mesh));
  const SectorDofs dofs = number_dofs(mesh, std::vector<int>());
  const AddedFunctions functions(mesh);
  const Material material = test::steel();
  const double shear = material.young / (2 * (1 + material.poisson));
  const double lame = 2 * shear * material.poisson / (1 - 2 * material.poisson);
  // u = (x^2 + y z, x y, z^2): div u = 3 x + 2 z, Laplacian (2, 0, 2).
  const auto displacement = [](const Eigen::Vector3d& at) {
    return Eigen::Vector3d(at[0] * at[0] + at[1] * at[2], at[0] * at[1], at[2] * at[2]);
  };
  const Eigen::Vector3d load = -(shear * Eigen::Vector3d(2, 0, 2) + (lame + shear) * Eigen::Vector3d(3, 0, 2));
  ASSERT_GT(functions.dofs().sector(), 0);
  Eigen::VectorXd work = Eigen::VectorXd::Zero(functions.dofs().sector()), size = work;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const AddedCell added = functions.integrate(cell, dofs, material);
    const auto nodes = nodes_of(mesh.cells, cell);
    Eigen::VectorXd moved(3 * nodes.size()), accelerated(3 * nodes.size());
    for (Eigen::Index k = 0; k < nodes.size(); ++k) {
      const Eigen::Matrix3d frame = cylindrical_frame(mesh.nodes.col(nodes[k]));
      moved.segment<3>(3 * k) = frame.transpose() * displacement(mesh.nodes.col(nodes[k]));
      accelerated.segment<3>(3 * k) = frame.transpose() * load / material.density;
    }
    const Eigen::VectorXd of_load = added.mass.cast<double>() * accelerated, of_stress = added.coupling * moved;
    for (std::size_t f = 0; f < added.functions.size(); ++f) {
      const auto at = static_cast<Eigen::Index>(3 * f);
      work.segment<3>(added.functions[f]) += of_load.segment<3>(at) - of_stress.segment<3>(at);
      size.segment<3>(added.functions[f]) += of_stress.segment<3>(at).cwiseAbs();
    }
  }
  constexpr double single_precision = 1e-6;  // of the mass
  EXPECT_LT(work.lpNorm<Eigen::Infinity>(), single_precision * size.lpNorm<Eigen::Infinity>());
}

TEST(AddedFunctions, OnATipOfTrianglesHaveTheLoadsOfAnEvenTraction) {
  // 27 L1 L2 L3 has the mean 27 * 2/5! = 0.45 over a flat triangle. That of an edge's function is zero.
  const test::BrickGrid grid({2, 2, 2}, 27, test::Around::open);
  SectorMesh mesh = grid.place(
      [](const Eigen::Vector3d& at) { return Eigen::Vector3d(0.2 + 0.1 * at[0], 0.1 * (at[1] - 0.5), 0.1 * at[2]); });
  mesh.sector_count = 1;
  mesh.clamped = grid.layer(0, 0);
  for (int k = 0; k <= 4; ++k) mesh.contact_line.push_back(grid.node(4, 2, k));
  SectorMesh tetrahedra = test::split(mesh, test::Split::tet10);
  std::vector<std::vector<int>> faces;
  for (int cell = 0; cell < tetrahedra.cell_count(); ++cell) {
    const auto nodes = nodes_of(tetrahedra.cells, cell);
    const CellKind& kind = cell_kind(10);
    for (const std::vector<int>& around : kind.faces) {
      std::vector<int> face;
      for (const int corner : around) face.push_back(nodes[corner]);
      for (std::size_t k = 0; k < 3; ++k) face.push_back(nodes[kind.middle_of(around[k], around[(k + 1) % 3])]);
      if (std::all_of(face.begin(), face.end(), [&](int node) { return tetrahedra.nodes(0, node) > 0.3 - 1e-9; }))
        faces.push_back(face);
    }
  }
  ASSERT_EQ(faces.size(), 8);  // two of each brick
  tetrahedra.tip_faces.resize(6, 8);
  for (int f = 0; f < 8; ++f) tetrahedra.tip_faces.col(f) = Eigen::Map<const Eigen::VectorXi>(faces[f].data(), 6);
  const ContactUnknowns contact = choose_contact(tetrahedra, ContactKind::segments, 1);
  int triangles = 0;
  for (const auto& [middles, weights] : contact.added_weights) {
    ASSERT_EQ(weights.size(), 1);
    EXPECT_NEAR(weights[0], middles.size() == 3 ? 0.45 / 8 : 0.0, 1e-12);
    triangles += middles.size() == 3;
  }
  EXPECT_EQ(triangles, 8);
  const Eigen::MatrixXd loads = AddedFunctions(tetrahedra).contact_loads(contact.added_weights, 1);
  EXPECT_NEAR(loads.col(0).sum(), 0.45, 1e-12);
}

TEST(AddedFunctions, ServeMeshesWhoseNeighboursAgree) {
  test::Annulus annulus = test::skewed_annulus(5);
  EXPECT_TRUE(AddedFunctions::serve(annulus.sector()));
  annulus.nodes_per_brick = 27;
  SectorMesh mesh = annulus.sector();
  EXPECT_TRUE(AddedFunctions::serve(mesh));
  EXPECT_TRUE(AddedFunctions::serve(test::split(mesh, test::Split::bricks_and_wedges)));
  mesh.cells.col(0).tail<7>().setConstant(-1);  // a brick of 20 nodes beside others of 27
  EXPECT_FALSE(AddedFunctions::serve(mesh));
}

TEST(AddedFunctions, DoNotServeCutsThatAreDividedDifferently) {
  // Tetrahedra of which those at one cut are mirrored; the nodes of both cuts still pair, because both diagonals of a
  // face have the same middle.
  test::Annulus annulus;
  annulus.nodes_per_brick = 27;
  annulus.bricks = {2, 2, 1};
  SectorMesh mesh = annulus.sector();
  const SectorMesh alike = test::split(mesh, test::Split::tet10);
  EXPECT_TRUE(AddedFunctions::serve(alike));
  SectorMesh different = alike;
  std::swap(different.cyclic_high[0], different.cyclic_high[1]);
  EXPECT_FALSE(AddedFunctions::serve(different));
}

}  // namespace
}  // namespace tiprub::reduce
