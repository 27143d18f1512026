// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/second_order_gap.h"

#include <gtest/gtest.h>

#include "reduce/sector/contact_line.h"
#include "tests/reduce/brick_grid.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::second_order_gap_test {
namespace {

/// So slender that shear changes the fourth digit only, and without Poisson's ratio, so that the clamp doesn't stress
/// its neighbourhood.
constexpr double root = 0.5, length = 1.0, width = 0.02, thickness = 0.012;  // [m] radius, radial, axial, tangential
constexpr int bricks_along = 24;

/// A straight radial cantilever of one body, whose tip line runs along its width.
SectorMesh bar() {
  const test::BrickGrid grid({bricks_along, 2, 2}, 20, test::Around::open);
  SectorMesh mesh = grid.place([](const Eigen::Vector3d& at) -> Eigen::Vector3d {
    return {root + length * at[0], thickness * (at[1] - 0.5), width * (at[2] - 0.5)};
  });
  mesh.sector_count = 1;
  mesh.clamped = grid.layer(0, 0);
  for (int k = 0; k <= 4; ++k) mesh.contact_line.push_back(grid.node(2 * bricks_along, 2, k));
  return mesh;
}

ReductionParameters parameters() {
  ReductionParameters of_bar;
  of_bar.material = test::steel();
  of_bar.material.poisson = 0.0;
  return of_bar;
}

SecondOrderGap second_order_of(const SectorMesh& mesh, const ContactUnknowns& contact) {
  const SectorDofs dofs = number_dofs(mesh, contact);
  const ReductionParameters of_bar = parameters();
  const SpinningSector sector(mesh, dofs, of_bar);
  return second_order_gap(sector, sector.factorize(0.0), contact);
}

TEST(SecondOrderGap, ShortensABarThatATipLoadBends) {
  const SectorMesh mesh = bar();
  const int middle = mesh.contact_line[2];
  test::TestRotor rotor(mesh, {middle}, parameters().material);
  // Static shapes of unit forces on the middle of the tip: along the bar, and across it.
  const Eigen::MatrixXd flexibility =
      test::solved(test::dense(rotor.at_rest()), Eigen::MatrixXd(rotor.dofs().contact_loads));
  const double bend = (rotor.dofs().contact_loads.transpose() * flexibility)(2, 2);
  const double shortening = -second_order_displacement(rotor.elasticity(), mesh, rotor.dofs(),
                                                       {flexibility.col(2) / bend, flexibility.col(0)})[0](0, 0);
  EXPECT_NEAR(shortening * length, 0.6, 1e-3);
  // Deflection and shortening of the elastica, over the length, at P L^2 / E I = 0.2, 0.5, 1 (Mattiasson 1981).
  struct {
    double across, along, within;
  } const elastica[] = {{0.06636, 0.00265, 0.01}, {0.16214, 0.01592, 0.02}, {0.30172, 0.05643, 0.04}};
  for (const auto& [across, along, within] : elastica)
    EXPECT_NEAR(shortening * length * across * across / along, 1.0, within);
}

TEST(SecondOrderGap, ContractedWithTheSpinLoadGivesTheStiffeningByTension) {
  // phi' K_sigma phi = int T w'^2 dx, with the tension T = rho A Omega^2 ((r + L)^2 - (r + x)^2)/2 and w = (3 x^2 L -
  // x^3)/(2 L^3), which a tip load bends; for r = L/2 the integral is 9/8 (8/3 - 3 + 2/5 + 1/2 - 1/7) rho A L
  // Omega^2.
  const SectorMesh mesh = bar();
  test::TestRotor rotor(mesh, {mesh.contact_line[2]}, parameters().material);
  const Eigen::MatrixXd K = test::dense(rotor.at_rest());
  const Eigen::VectorXd bent = test::solved(K, Eigen::MatrixXd(rotor.dofs().contact_loads).col(2));
  const double deflection = (rotor.dofs().contact_loads.transpose() * bent)(2);
  const Eigen::VectorXd spun = test::solved(K, rotor.elasticity().centrifugal_load());
  const double Q =
      second_order_displacement(rotor.elasticity(), mesh, rotor.dofs(), {bent / deflection, spun})[0](0, 0);
  const double tension = 9.0 / 8 * (8.0 / 3 - 3 + 2.0 / 5 + 1.0 / 2 - 1.0 / 7) * parameters().material.density *
                         width * thickness * length;
  EXPECT_NEAR(-2 * Q / tension, 1.0, 2e-3);
}

TEST(SecondOrderGap, ShortensABarThatVibrates) {
  // The first mode w of a cantilever has int w'^2 / 2 = 0.5810 w(L)^2 / L.
  const SectorMesh mesh = bar();
  const ContactUnknowns contact = choose_contact(mesh, ContactKind::points, 3);
  const SecondOrderGap gap = second_order_of(mesh, contact);
  ASSERT_EQ(gap.displacement.size(), 3u);
  EXPECT_NEAR(gap.curvature(1, 0), 1 / (root + length), 1e-12);
  EXPECT_NEAR(gap.curvature(1, 1), 0.0, 1e-9);
  for (const int direction : {1, 2}) {
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(3, 3);
    motion.row(direction).setOnes();
    const Eigen::VectorXd y = gap.coordinates.transpose() * motion.reshaped();
    for (const Eigen::MatrixXd& Q : gap.displacement) EXPECT_NEAR(y.dot(Q * y) * length, -0.5810, 3e-3);
  }
}

TEST(SecondOrderGap, OfASectorIsThatOfOneWhoseCutFacesAreClamped) {
  test::Annulus annulus = test::skewed_annulus(5);
  annulus.bricks = {2, 4, 1};  // has faces of the tip
  const SectorMesh mesh = annulus.sector();
  SectorMesh alone = mesh;
  for (std::vector<int>* face : {&alone.cyclic_low, &alone.cyclic_high}) {
    alone.clamped.insert(alone.clamped.end(), face->begin(), face->end());
    face->clear();
  }
  alone.sector_count = 1;
  for (const ContactKind kind : {ContactKind::points, ContactKind::segments}) {
    const SecondOrderGap gap = second_order_of(mesh, choose_contact(mesh, kind, 2));
    const SecondOrderGap of_clamped = second_order_of(alone, choose_contact(alone, kind, 2));
    EXPECT_EQ(gap.curvature, of_clamped.curvature);
    EXPECT_LT((gap.coordinates - of_clamped.coordinates).norm(), 1e-4 * of_clamped.coordinates.norm());
    ASSERT_EQ(gap.displacement.size(), of_clamped.displacement.size());
    for (std::size_t k = 0; k < gap.displacement.size(); ++k)
      EXPECT_LT((gap.displacement[k] - of_clamped.displacement[k]).norm(), 1e-4 * of_clamped.displacement[k].norm());
  }
}

TEST(SecondOrderGap, HasCoordinatesThatAreDisplacements) {
  const SectorMesh mesh = bar();
  const SecondOrderGap gap = second_order_of(mesh, choose_contact(mesh, ContactKind::points, 3));
  const Eigen::MatrixXd& V = gap.coordinates;
  const Eigen::MatrixXd motions = V * (V.transpose() * V).inverse();  // for which y is a unit vector
  for (const auto& motion : motions.colwise()) {
    EXPECT_NEAR(motion.maxCoeff(), 1.0, 1e-9);
    EXPECT_GE(motion.minCoeff(), -1.0 - 1e-9);
  }
  for (const Eigen::MatrixXd& Q : gap.displacement) EXPECT_EQ(Q, Q.transpose());
}

}  // namespace
}  // namespace tiprub::reduce::second_order_gap_test
