// SPDX-License-Identifier: GPL-3.0-or-later
// Rotating beams and discs that have answers in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "reduce/model/dense_eigen.h"
#include "tests/reduce/brick_grid.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::dense;
using test::TestRotor;

/// Slender enough that shear and rotary inertia change the fourth digit only, and without Poisson's ratio, so that
/// the clamp doesn't stress its neighbourhood.
constexpr double length = 1.0, width = 0.01, thickness = 0.006;  // [m] radial, axial, tangential
constexpr int bricks_along = 32;

Material beam_material() {
  Material material = test::steel();
  material.poisson = 0.0;
  return material;
}

/// A straight radial cantilever whose root stands at `hub` times its length from the axis.
SectorMesh beam(double hub) {
  const test::BrickGrid grid({bricks_along, 1, 1}, 20, test::Around::open);
  SectorMesh mesh = grid.place([=](const Eigen::Vector3d& at) -> Eigen::Vector3d {
    return {length * (hub + at[0]), thickness * (at[1] - 0.5), width * (at[2] - 0.5)};
  });
  mesh.sector_count = 1;
  mesh.clamped = grid.layer(0, 0);
  return mesh;
}

struct Coefficients {
  double flap = 0, lag = 0;
};

/// d(omega^2)/d(Omega^2) at rest of the first bending modes out of the plane of rotation (flap) and in it (lag): the
/// Rayleigh quotient of the stiffness's change on the mode at rest. Stress-only prestress is linear in Omega^2, so
/// that any speed gives the derivative; a high one leaves no cancellation.
Coefficients coefficients(double hub) {
  TestRotor rotor(beam(hub), {}, beam_material());
  const double speed = 1000.0;
  const Eigen::MatrixXd K = dense(rotor.at_rest()), M = dense(rotor.mass());
  const Eigen::MatrixXd change = dense(rotor.at_speed(speed, Prestress::stress_only)) - K;
  const RealEigenpairs modes = eigenpairs(K, M);
  Coefficients found;
  for (int mode = 0; mode < 2; ++mode) {
    const Eigen::VectorXd shape = modes.vectors.col(mode);
    const double quotient = shape.dot(change * shape) / (speed * speed * shape.dot(M * shape));
    double axial = 0;
    for (Eigen::Index dof = 2; dof < shape.size(); dof += 3) axial += shape[dof] * shape[dof];
    (axial > 0.5 * shape.squaredNorm() ? found.flap : found.lag) = quotient;
  }
  return found;
}

TEST(RotatingCantilever, StiffensAsABeamDoes) {
  // Euler-Bernoulli, first mode (Southwell; hub ratio 0 and 0.5).
  const Coefficients at_axis = coefficients(1e-3);  // no node on the axis; the coefficient is linear in the hub ratio
  const Coefficients off_axis = coefficients(0.5);
  const double slope = (1.97878 - 1.19334) / 0.5;
  EXPECT_NEAR(at_axis.flap / (1.19334 + 1e-3 * slope), 1.0, 1e-3);
  EXPECT_NEAR(off_axis.flap / 1.97878, 1.0, 1e-3);
  EXPECT_NEAR(off_axis.lag / 0.97878, 1.0, 1e-3);
  EXPECT_NEAR(at_axis.lag - (0.19334 + 1e-3 * slope), 0.0, 1e-3);
}

TEST(RotatingCantilever, SoftensByExactlyTheSpeedInItsPlane) {
  // Flap and lag differ by spin softening alone: one.
  const Coefficients found = coefficients(0.5);
  EXPECT_NEAR(found.flap - found.lag, 1.0, 1e-3);
}

/// Plane stress in a disc held at its bore a and free at its rim b, over rho Omega^2.
struct Disc {
  double a, b, poisson;
  double A = 0, B = 0;  // sigma_r = A - B / r^2 - (3 + nu)/8 r^2, sigma_theta = A + B / r^2 - (1 + 3 nu)/8 r^2
  Disc(double bore, double rim, double nu) : a(bore), b(rim), poisson(nu) {
    // sigma_r(b) = 0 and u(a) = r (sigma_theta - nu sigma_r) / E = 0.
    Eigen::Matrix2d left;
    left << 1, -1 / (b * b), 1 - nu, (1 + nu) / (a * a);
    const Eigen::Vector2d right((3 + nu) / 8 * b * b, ((1 + 3 * nu) - nu * (3 + nu)) / 8 * a * a);
    const Eigen::Vector2d found = left.partialPivLu().solve(right);
    A = found[0];
    B = found[1];
  }
  double von_mises(double r) const {
    const double radial = A - B / (r * r) - (3 + poisson) / 8 * r * r;
    const double hoop = A + B / (r * r) - (1 + 3 * poisson) / 8 * r * r;
    return std::sqrt(radial * radial - radial * hoop + hoop * hoop);
  }
};

TEST(RotatingDisc, IsStressedAsInPlaneStress) {
  // Thin, and looked at some thicknesses away from the clamp.
  test::Annulus annulus;
  annulus.sector_count = 24;
  annulus.bricks = {24, 1, 1};
  annulus.height = 0.002;
  SectorMesh mesh = annulus.sector();
  TestRotor rotor(mesh, {mesh.contact_line.front()});
  const double speed = 600.0, scale = test::steel().density * speed * speed;
  const Eigen::VectorXd found = rotor.elasticity().von_mises(rotor.static_displacement(speed), Prestress::linear);
  const Disc disc(annulus.inner, annulus.outer, test::steel().poisson);
  int compared = 0;
  FiniteElements(rotor.mesh()).visit([&](const CellPoints& points) {
    const Eigen::RowVectorXd radius = points.position.topRows<2>().colwise().norm();
    if (radius.minCoeff() < annulus.inner + 10 * annulus.height) return;
    double exact = 0;
    for (const double r : radius) exact = std::max(exact, scale * disc.von_mises(r));
    EXPECT_NEAR(found[points.cell] / exact, 1.0, 2e-3);
    ++compared;
  });
  EXPECT_GT(compared, 5);
}

}  // namespace
}  // namespace tiprub::reduce
