// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/cubic_bricks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "mesh/cells/cell_kind.h"
#include "reduce/basis/cyclic_modes.h"
#include "reduce/model/fields_file.h"
#include "reduce/reduction.h"
#include "reduce/sector/contact_unknowns.h"
#include "reduce/sector/refinement.h"
#include "tests/cases/complaint.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/split_cells.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::dense;
using test::TestRotor;

/// Bricks that are parallelepipeds, with axes in all directions.
class CubicBricks : public ::testing::TestWithParam<int> {
 protected:
  CubicBricks() {
    const test::BrickGrid grid({2, 3, 2}, GetParam(), test::Around::open);
    SectorMesh mesh = grid.place([](const Eigen::Vector3d& at) -> Eigen::Vector3d {
      return {1 + 0.3 * at[0] + 0.1 * at[1], -0.1 * at[0] + 0.4 * at[1] + 0.05 * at[2], 0.2 * at[2]};
    });
    mesh.tip_faces = grid.outer_faces(0, 3);
    for (int k = 0; k <= 4; ++k) mesh.contact_line.push_back(grid.node(4, 2, k));
    for (int cell = 0; cell < mesh.cell_count(); ++cell) test::turn_axes(mesh, cell, cell % 4);
    mesh_ = with_cubic_bricks(mesh);
  }

  /// The coefficients of all functions that are nearest to a field in the mean square.
  Eigen::VectorXd projected(const std::function<double(const Eigen::Vector3d&)>& f) const {
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(mesh_.node_count(), mesh_.node_count());
    Eigen::VectorXd load = Eigen::VectorXd::Zero(mesh_.node_count());
    FiniteElements(mesh_).visit([&](const CellPoints& points) {
      for (Eigen::Index q = 0; q < points.weight.size(); ++q) {
        const Eigen::VectorXd weighted = points.weight[q] * points.shape.col(q);
        load(points.nodes) += f(points.position.col(q)) * weighted;
        mass(points.nodes, points.nodes) += weighted * points.shape.col(q).transpose();
      }
    });
    return test::solved(mass, load);
  }

  SectorMesh mesh_;
};
INSTANTIATE_TEST_SUITE_P(Nodes, CubicBricks, ::testing::Values(20, 27));

double cubic_field(const Eigen::Vector3d& x) {
  return 1 + x[0] - 2 * x[1] + x[2] * x[0] + 3 * x[0] * x[1] * x[2] - x[0] * x[0] * x[0] + 2 * x[1] * x[1] * x[2] +
         5 * x[2] * x[2] * x[2] - 4 * x[1] * x[1] * x[1];
}

TEST_P(CubicBricks, HaveAsManyFunctionsAsALatticeOfThirds) {
  EXPECT_EQ(mesh_.node_count(), (3 * 2 + 1) * (3 * 3 + 1) * (3 * 2 + 1));
  EXPECT_EQ(mesh_.cubic->points, (2 * 2 + 1) * (2 * 3 + 1) * (2 * 2 + 1));
}

TEST_P(CubicBricks, ReproduceCubicFieldsAndTheirGradients) {
  const Eigen::VectorXd found = projected(cubic_field);
  const double step = 1e-6;
  FiniteElements(mesh_).visit([&](const CellPoints& points) {
    for (Eigen::Index q = 0; q < points.weight.size(); ++q) {
      const Eigen::Vector3d at = points.position.col(q);
      EXPECT_NEAR(points.shape.col(q).dot(found(points.nodes)), cubic_field(at), 1e-11);
      const Eigen::Vector3d slope = points.gradient[q].transpose() * found(points.nodes);
      for (int d = 0; d < 3; ++d) {
        const Eigen::Vector3d aside = step * Eigen::Vector3d::Unit(d);
        EXPECT_NEAR(slope[d], (cubic_field(at + aside) - cubic_field(at - aside)) / (2 * step), 1e-8);
      }
    }
  });
}

TEST_P(CubicBricks, HaveTheFieldsValuesAtTheNodesForUnknowns) {
  const Eigen::VectorXd found = projected(cubic_field);
  for (int node = 0; node < mesh_.cubic->points; ++node)
    EXPECT_NEAR(found[node], cubic_field(mesh_.nodes.col(node)), 1e-10);
}

TEST_P(CubicBricks, SpreadSegmentsOverTheWholeField) {
  // One segment: its displacement is the mean over the flat tip, x = 1.3 + 0.1 b, y = -0.1 + 0.4 b + 0.05 c, z = 0.2
  // c. By two points of Gauss along each axis, which are exact for the third degree.
  const ContactUnknowns contact = choose_contact(mesh_, ContactKind::segments, 1);
  const Eigen::VectorXd found = projected(cubic_field);
  double mean = 0;
  for (const double b : {-1.0, 1.0})
    for (const double c : {-1.0, 1.0}) {
      const double beta = (1 + b / std::sqrt(3)) / 2, gamma = (1 + c / std::sqrt(3)) / 2;
      mean += cubic_field({1.3 + 0.1 * beta, -0.1 + 0.4 * beta + 0.05 * gamma, 0.2 * gamma}) / 4;
    }
  EXPECT_NEAR((contact.weights * found(contact.tip))[0], mean, 1e-10);
  EXPECT_NEAR(contact.line.position(0, 2), 0.1, 1e-12);
}

TEST(CubicWheel, HasTheFrequenciesOfItsSector) {
  // As in wheel_test.cc. One brick a sector: its edges go from one cut to the other.
  for (const int N : {4, 5}) {
    test::Annulus annulus = test::skewed_annulus(N);
    annulus.bricks = {1, 1, 1};
    TestRotor wheel(with_cubic_bricks(annulus.wheel()), {});
    TestRotor sector(with_cubic_bricks(annulus.sector()), {});
    EXPECT_EQ(wheel.dofs().sector(), N * sector.dofs().independent());
    const Eigen::VectorXd whole = test::generalized_eigenvalues(dense(wheel.at_rest()), dense(wheel.mass()));
    std::vector<double> joined;
    for (int n = 0; n <= N / 2; ++n)
      for (const double value : test::generalized_eigenvalues(test::cyclic(sector.at_rest(), sector.dofs(), N, n),
                                                              test::cyclic(sector.mass(), sector.dofs(), N, n)))
        joined.insert(joined.end(), n == 0 || 2 * n == N ? 1 : 2, value);
    std::sort(joined.begin(), joined.end());
    ASSERT_EQ(static_cast<Eigen::Index>(joined.size()), whole.size());
    for (Eigen::Index k = 0; k < whole.size(); ++k) EXPECT_NEAR(joined[k] / whole[k], 1.0, 1e-9) << k;
  }
}

/// [Hz] of a rotor without cuts.
Eigen::VectorXd frequencies(TestRotor& rotor, int count) {
  const SymmetricMatrix mass = rotor.mass();
  const SectorFactor factor(rotor.at_rest(), rotor.dofs());
  const CyclicTransformation wave(rotor.dofs(), 1, 0);
  return lowest_modes(CyclicSolver(factor, wave), mass, ContactNodes::free, count, 1e-10).frequencies();
}

TEST(CubicBar, ConvergesWithTheSixthOrder) {
  // A bar without Poisson's ratio, held at one end, vibrates along its axis as sin(pi x / 2l): an exact solution of
  // three-dimensional elasticity.
  const auto error = [](int bricks) {
    const test::BrickGrid grid({bricks, 1, 1}, 20, test::Around::open);
    SectorMesh mesh = grid.place([](const Eigen::Vector3d& at) -> Eigen::Vector3d {
      return {3 + at[0], 0.4 * at[1], 0.4 * at[2]};
    });
    mesh.sector_count = 1;
    mesh.clamped = grid.layer(0, 0);
    Material material = test::steel();
    material.poisson = 0;
    TestRotor rotor(with_cubic_bricks(mesh), {}, material);
    const double exact = std::sqrt(material.young / material.density) / 4;
    return (frequencies(rotor, 6).array() / exact - 1).abs().minCoeff();
  };
  const double coarse = error(1), fine = error(2);
  EXPECT_LT(fine, 2e-6);
  EXPECT_NEAR(std::log2(coarse / fine), 6.0, 0.3);
}

TEST(CubicBricksOfADisc, AreNearerToARefinedMesh) {
  // Rayleigh-Ritz: quadratic displacements are among the cubic ones.
  for (const int nodes : {20, 27}) {
    test::Annulus annulus = test::skewed_annulus(1);
    annulus.bricks = {1, 6, 1};
    annulus.nodes_per_brick = nodes;
    const SectorMesh mesh = annulus.wheel();
    TestRotor given(mesh, {}), cubic(with_cubic_bricks(mesh), {}), fine(refined(refined(mesh)), {});
    const Eigen::VectorXd at_two = frequencies(given, 6), at_three = frequencies(cubic, 6),
                          exact = frequencies(fine, 6);
    for (Eigen::Index k = 0; k < exact.size(); ++k) {
      EXPECT_LT(at_three[k], at_two[k]);
      EXPECT_LT(std::abs(at_three[k] - exact[k]), 0.25 * (at_two[k] - exact[k])) << k;
    }
  }
}

TEST(CubicBricksThatNothingHolds, HaveSixRigidMotions) {
  test::Annulus annulus = test::skewed_annulus(5);
  annulus.bricks = {1, 2, 1};
  annulus.bore = test::Bore::free;
  TestRotor rotor(with_cubic_bricks(annulus.sector()), {});
  const Eigen::VectorXd eigenvalues = test::generalized_eigenvalues(dense(rotor.at_rest()), dense(rotor.mass()));
  EXPECT_LT(eigenvalues.head(6).cwiseAbs().maxCoeff(), 1e-9 * eigenvalues[6]);
}

TEST(CubicModel, HasContactAtMidSideNodesAndFieldsAtTheNodesOfTheFile) {
  // Of five contact nodes the second and the fourth are in the middle of edges.
  test::Annulus annulus = test::skewed_annulus(5);
  annulus.bricks = {1, 2, 2};
  const SectorMesh given = annulus.sector(), mesh = with_cubic_bricks(given);
  ReductionParameters parameters;
  parameters.material = test::steel();
  parameters.speed_max = 1000;
  parameters.contact = ContactKind::points;
  parameters.contact_nodes = 5;
  parameters.fixed_interface_modes = 12;
  parameters.verification_speeds = {0.0};
  parameters.verification_modes = 4;
  parameters.verification_tolerance = 1e-9;
  parameters.frequency_tolerance = 1e-2;
  const std::string path = testing::TempDir() + "cubic_fields.h5";
  FieldsWriter writer(path, "test");
  ReductionReport report;
  const ReducedModel model = reduce(mesh, parameters, Progress::Shown::never, report, &writer, test::alone());
  writer.close(digest(model));
  TestRotor rotor(mesh, given.contact_line);
  EXPECT_EQ(report.sector_dofs, rotor.dofs().sector());
  const FieldsReader reader(path);
  EXPECT_EQ(reader.sector().nodes, given.nodes);
  for (int n = 0; n <= 2; ++n) {
    const Eigen::MatrixXcd K = test::cyclic(rotor.at_rest(), rotor.dofs(), 5, n);
    const Eigen::MatrixXcd forces = Eigen::MatrixXcd::Identity(K.rows(), K.cols()).rightCols(15);
    const Eigen::MatrixXcd& K0 = model.nodal_diameters[n].K[0];
    const Eigen::MatrixXcd unit = Eigen::MatrixXcd::Identity(K0.rows(), 15);
    EXPECT_LT(test::difference(test::solved(K0, unit).topRows(15), test::solved(K, forces).bottomRows(15)), 1e-9);
    const Eigen::MatrixXcd shapes = reader.expand(n, Eigen::MatrixXcd::Identity(reader.dofs(n), 15));
    ASSERT_EQ(shapes.rows(), 3 * given.node_count());
    for (int k = 0; k < 5; ++k) {
      const Eigen::MatrixXcd moved = shapes.middleRows<3>(3 * given.contact_line[k]);
      EXPECT_LT((moved - Eigen::MatrixXcd::Identity(15, 15).middleRows(3 * k, 3)).cwiseAbs().maxCoeff(), 1e-6);
    }
  }
  std::filesystem::remove(path);
}

TEST(CubicBricksOnly, AreMadeOfBricks) {
  test::Annulus annulus = test::skewed_annulus(5);
  annulus.nodes_per_brick = 27;
  SectorMesh mesh = test::split(annulus.sector(), test::Split::wedge15);
  mesh.file = "sector.msh";
  EXPECT_EQ(complaint<InputError>([&] { with_cubic_bricks(mesh); }),
            "sector.msh: cell 0 is a wedge15; [reduce] element_order = 3 takes bricks of 20 or 27 nodes only: leave "
            "element_order at 2, or set refine = 1");
}

}  // namespace
}  // namespace tiprub::reduce
