// SPDX-License-Identifier: GPL-3.0-or-later
// Contact by segments, from the sector to the model: what it does to the statics, and what it doesn't to the
// dynamics.
#include <gtest/gtest.h>

#include <filesystem>

#include "reduce/model/fields_file.h"
#include "reduce/model/reduced_model.h"
#include "reduce/operators/cyclic_solver.h"
#include "reduce/reduction.h"
#include "reduce/sector/contact_unknowns.h"
#include "reduce/sector/cubic_bricks.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::segments_test {
namespace {

using test::cyclic;

constexpr int sectors = 5;

SectorMesh sector() {
  test::Annulus annulus = test::skewed_annulus(sectors);
  annulus.bricks = {2, 4, 2};
  return annulus.sector();
}

ReductionParameters parameters() {
  ReductionParameters p;
  p.material = test::steel();
  p.speed_max = 3000.0;
  p.contact = ContactKind::segments;
  p.contact_nodes = 3;
  p.fixed_interface_modes = 16;
  p.verification_speeds = {0.0, 0.6};
  p.verification_modes = 6;
  p.verification_tolerance = 1e-9;
  p.frequency_tolerance = 1e-3;
  p.polynomial_tolerance = 1e-3;
  return p;
}

ReducedModel reduced(const ReductionParameters& of) {
  ReductionReport report;
  return reduce(sector(), of, Progress::Shown::never, report, nullptr, test::alone());
}

/// The consistent loads of unit forces on segments; independent x contact dofs.
Eigen::MatrixXcd consistent_loads(const SectorMesh& mesh, const SectorDofs& dofs) {
  const ContactUnknowns contact = choose_contact(mesh, ContactKind::segments, 3);
  Eigen::MatrixXcd loads = Eigen::MatrixXcd::Zero(dofs.independent(), 9);
  for (Eigen::Index k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < contact.tip.size(); ++i)
      loads.block<3, 3>(dofs.first[contact.tip[i]], 3 * k)
          .diagonal()
          .setConstant(contact.weights(k, static_cast<Eigen::Index>(i)));
  return loads;
}

TEST(Segments, AreAsSoftAsTheUnreducedSector) {
  // Static displacement of every segment by a unit force on every segment, at rest: B' K^-1 B.
  for (const SectorMesh& mesh : {sector(), with_cubic_bricks(sector())}) {
    ReductionReport report;
    const ReducedModel model = reduce(mesh, parameters(), Progress::Shown::never, report, nullptr, test::alone());
    EXPECT_EQ(model.contact.kind, ContactKind::segments);
    test::TestRotor rotor(mesh, {});
    const Eigen::MatrixXcd loads = consistent_loads(mesh, rotor.dofs());
    for (int n = 0; n <= sectors / 2; ++n) {
      const Eigen::MatrixXcd K = cyclic(rotor.at_rest(), rotor.dofs(), sectors, n);
      const Eigen::MatrixXcd exact = loads.adjoint() * test::solved(K, loads);
      const Eigen::MatrixXcd& K0 = model.nodal_diameters[n].K[0];
      const Eigen::MatrixXcd unit = Eigen::MatrixXcd::Identity(K0.rows(), 9);
      EXPECT_LT(test::difference(test::solved(K0, unit).topRows(9), exact), 1e-9);
    }
  }
}

TEST(Segments, AreHeldByTheirDisplacementsAlone) {
  const SectorMesh mesh = sector();
  const SectorDofs dofs = number_dofs(mesh, choose_contact(mesh, ContactKind::segments, 3));
  const RotatingElasticity elasticity(mesh, dofs, test::steel());
  const SymmetricMatrix at_rest =
      elasticity.stiffness(0, Eigen::Matrix3Xd::Zero(3, mesh.node_count()), Prestress::linear);
  const SectorFactor factor(at_rest, dofs);
  for (int n = 0; n <= sectors / 2; ++n) {
    const CyclicSolver solver(factor, {dofs, sectors, n});
    const Eigen::MatrixXcd K = cyclic(at_rest, dofs, sectors, n), loads = consistent_loads(mesh, dofs);
    // Constraint modes move one by one, and forces on segments are all that holds them.
    const Eigen::MatrixXcd modes = solver.constraint_modes();
    EXPECT_LT((loads.adjoint() * modes - Eigen::MatrixXcd::Identity(9, 9)).norm(), 1e-10);
    EXPECT_LT(test::difference(loads * (modes.adjoint() * K * modes), K * modes), 1e-8);
    // With segments held: the load is met but for forces on segments.
    Eigen::MatrixXcd b = test::arbitrary(K.rows(), 3);
    if (n == 0) b = b.real().eval();
    const Eigen::MatrixXcd x = solver.solve(b, ContactNodes::fixed);
    EXPECT_LT((loads.adjoint() * x).norm(), 1e-10 * x.norm());
    EXPECT_LT(test::difference(loads * (modes.adjoint() * (K * x - b)), K * x - b), 1e-8);
  }
}

TEST(Segments, LeaveTheFrequenciesOfTheSectorAlone) {
  const ReducedModel model = reduced(parameters());
  EXPECT_NO_THROW(check(model, "model"));
  ReductionParameters by_points = parameters();
  by_points.contact = ContactKind::points;
  const ReducedModel points = reduced(by_points);
  for (std::size_t n = 0; n < 3; ++n)
    EXPECT_LT(test::difference(model.verification.unreduced[n], points.verification.unreduced[n]), 1e-9);
  EXPECT_LT(model_error(model, 30).error, 5e-3);
}

TEST(Segments, AreMeansOfTheFieldsThatAreRecovered) {
  // A unit of a segment's dof is a shape of unit mean there; the generalized dofs leave all segments where they are.
  const std::string path = testing::TempDir() + "segments_fields.h5";
  FieldsWriter writer(path, "test");
  ReductionReport report;
  const ReducedModel model = reduce(sector(), parameters(), Progress::Shown::never, report, &writer, test::alone());
  writer.close(digest(model));
  const FieldsReader reader(path);
  const ContactUnknowns contact = choose_contact(sector(), ContactKind::segments, 3);
  EXPECT_EQ(reader.sector().node_set("contact"), contact.nodes);
  for (int n = 0; n <= sectors / 2; ++n) {
    const Eigen::Index dofs = reader.dofs(n);
    const Eigen::MatrixXcd shapes = reader.expand(n, Eigen::MatrixXcd::Identity(dofs, dofs));
    Eigen::MatrixXcd means = Eigen::MatrixXcd::Zero(9, dofs);
    for (Eigen::Index k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < contact.tip.size(); ++i)
        means.middleRows<3>(3 * k) +=
            contact.weights(k, static_cast<Eigen::Index>(i)) * shapes.middleRows<3>(3 * contact.tip[i]);
    const double largest = shapes.cwiseAbs().maxCoeff();
    EXPECT_LT((means - Eigen::MatrixXcd::Identity(9, dofs)).cwiseAbs().maxCoeff(), 1e-6 * largest);  // float32
  }
  std::filesystem::remove(path);
}

TEST(Segments, ShiftAsTheirMeanDoes) {
  const ReducedModel model = reduced(parameters());
  const SectorMesh mesh = sector();
  test::TestRotor rotor(mesh, {});
  const Eigen::Matrix3Xd exact = rotor.static_displacement(1500.0);
  const ContactUnknowns contact = choose_contact(mesh, ContactKind::segments, 3);
  Eigen::MatrixX3d mean = Eigen::MatrixX3d::Zero(3, 3);
  for (std::size_t i = 0; i < contact.tip.size(); ++i)
    mean += contact.weights.col(static_cast<Eigen::Index>(i)) * exact.col(contact.tip[i]).transpose() *
            cylindrical_frame(mesh.nodes.col(contact.tip[i]));
  EXPECT_LT((model.contact.static_shift(1500.0) - mean).norm(), 1e-9 * mean.norm());
}

TEST(Segments, StretchABarAsItsUniformPressureDoes) {
  // One segment over the end of a bar, far from the axis so that its radial direction is one: L / (E A) exactly.
  constexpr double length = 1.0, width = 0.05, thickness = 0.02, hub = 1e4;  // [m]
  const test::BrickGrid grid({4, 1, 2}, 20, test::Around::open);
  SectorMesh mesh = grid.place([](const Eigen::Vector3d& at) -> Eigen::Vector3d {
    return {hub + length * at[0], thickness * (at[1] - 0.5), width * (at[2] - 0.5)};
  });
  mesh.sector_count = 1;
  mesh.clamped = grid.layer(0, 0);
  for (int k = 0; k <= 4; k += 2) mesh.contact_line.push_back(grid.node(8, 1, k));
  mesh.tip_faces = grid.outer_faces(0, 1);
  Material material = test::steel();
  material.poisson = 0;
  const SectorDofs dofs = number_dofs(mesh, choose_contact(mesh, ContactKind::segments, 1));
  const RotatingElasticity elasticity(mesh, dofs, material);
  const Eigen::MatrixXd K =
      test::dense(elasticity.stiffness(0, Eigen::Matrix3Xd::Zero(3, mesh.node_count()), Prestress::linear));
  const Eigen::VectorXd pressure = dofs.contact_loads.col(0);
  const Eigen::VectorXd moved = test::solved(K, pressure);
  EXPECT_NEAR(pressure.dot(moved) * material.young * width * thickness / length, 1.0, 1e-8);
  ReductionParameters p = parameters();
  p.material = material;
  p.contact_nodes = 1;
  p.speed_max = 1.0;
  ReductionReport report;
  const ReducedModel model =
      reduce(mesh, p, Progress::Shown::never, report, nullptr, test::alone());  // no cut faces, no contact nodes
  const Eigen::MatrixXcd& K0 = model.nodal_diameters[0].K[0];
  const Eigen::VectorXcd answer = test::solved(K0, Eigen::VectorXcd::Unit(K0.rows(), 0));
  EXPECT_NEAR(answer[0].real() * material.young * width * thickness / length, 1.0, 1e-8);
  // Uniform pressure stretches every fibre alike.
  for (const int node : grid.layer(0, 8)) EXPECT_NEAR(moved[dofs.first[node]] / pressure.dot(moved), 1.0, 1e-7);
}

}  // namespace
}  // namespace tiprub::reduce::segments_test
