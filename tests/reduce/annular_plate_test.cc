// SPDX-License-Identifier: GPL-3.0-or-later
// Annuli whose frequencies are known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reduce/basis/cyclic_modes.h"
#include "reduce/sector/cubic_bricks.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::TestRotor;

/// Lowest frequencies [Hz] at a speed; nodal diameters 0 .. last x modes.
Eigen::MatrixXd frequencies(TestRotor& rotor, double speed, int last, int modes) {
  const SymmetricMatrix mass = rotor.mass();
  const SectorFactor factor(rotor.at_speed(speed, Prestress::linear), rotor.dofs());
  Eigen::MatrixXd table(last + 1, modes);
  for (int n = 0; n <= last; ++n) {
    const CyclicTransformation wave(rotor.dofs(), rotor.mesh().sector_count, n);
    table.row(n) =
        lowest_modes(CyclicSolver(factor, wave), mass, ContactNodes::free, modes, 1e-8).frequencies().transpose();
  }
  return table;
}

/// First root k of J2(kb) Y1(ka) - Y2(kb) J1(ka): u_theta = J1(kr) Y1(ka) - Y1(kr) J1(ka) is held at a, and its shear
/// stress G (u' - u/r) vanishes at b. By bisection.
double torsional_wave_number(double a, double b) {
  const auto shear = [=](double k) {
    return std::cyl_bessel_j(2, k * b) * std::cyl_neumann(1, k * a) -
           std::cyl_neumann(2, k * b) * std::cyl_bessel_j(1, k * a);
  };
  double low = 0.1 / (b - a), high = low;
  while (shear(low) * shear(high) > 0) high *= 1.01;
  for (int step = 0; step < 100; ++step) {
    const double middle = 0.5 * (low + high);
    (shear(low) * shear(middle) > 0 ? low : high) = middle;
  }
  return low;
}

class Torsion : public ::testing::TestWithParam<std::tuple<int, double>> {
 protected:
  /// Relative error of the first torsional frequency, so many bricks each way.
  static double error(int bricks, Degree degree = Degree::quadratic) {
    test::Annulus annulus;
    annulus.sector_count = 12;
    annulus.bricks = {bricks, bricks, 1};
    std::tie(annulus.nodes_per_brick, annulus.wrap) = GetParam();
    SectorMesh mesh = annulus.sector();
    if (degree == Degree::cubic) mesh = with_cubic_bricks(mesh);
    TestRotor rotor(mesh, {mesh.contact_line.front()});
    const double k = torsional_wave_number(annulus.inner, annulus.outer);
    const double exact = k *
                         std::sqrt(test::steel().young / (2 * (1 + test::steel().poisson)) / test::steel().density) /
                         (2 * std::numbers::pi);
    return (frequencies(rotor, 0.0, 0, 5).array() / exact - 1).abs().minCoeff();  // the others are far from it
  }
};
INSTANTIATE_TEST_SUITE_P(StraightAndWrapped, Torsion,
                         ::testing::Combine(::testing::Values(20, 27), ::testing::Values(0.0, 0.2)));

TEST_P(Torsion, ConvergesWithTheFourthOrder) {
  // An exact solution of three-dimensional elasticity, without a singularity at the clamp: a quadratic element errs
  // by h^4 in frequency.
  const double coarse = error(4), fine = error(8);
  EXPECT_LT(fine, 1e-5);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.25);
}

TEST_P(Torsion, IsBetterWithCubicBricks) {
  // What is left is the geometry, which is quadratic.
  EXPECT_LT(error(4, Degree::cubic), error(4) / 8);
}

/// 1 mm of steel, clamped at its bore, in 120 narrow sectors: their first nodal diameters are the plate's, at little
/// cost. The clamp holds the thickness too, which plate theory doesn't know: bricks at the bore must be as small as
/// the plate is thin, or that stiffens all of their length.
TestRotor plate() {
  test::Annulus annulus;
  annulus.sector_count = 120;
  annulus.bricks = {40, 2, 1};
  annulus.grading = 0.7;
  annulus.height = 0.001;
  return test::tip_rotor(annulus);
}

TEST(AnnularPlate, BendsAsThinPlatesDo) {
  // Kirchhoff's plate, n nodal diameters, no nodal circle, at rest.
  const double exact[] = {79.409, 81.028, 89.649, 113.173, 156.058, 217.847};
  TestRotor rotor = plate();
  const Eigen::VectorXd found = frequencies(rotor, 0.0, 5, 1);
  for (int n = 0; n <= 5; ++n) EXPECT_NEAR(found[n] / exact[n], 1.0, 1e-3) << n;
}

TEST(AnnularPlate, StiffensUnderSpinAsThinPlatesDo) {
  // The same at 600 rad/s, with the membrane stress of a rotating disc clamped at its bore.
  const double exact[] = {161.999, 166.990, 183.058, 212.589, 257.575};
  TestRotor rotor = plate();
  const Eigen::VectorXd found = frequencies(rotor, 600.0, 4, 1);
  for (int n = 0; n <= 4; ++n) EXPECT_NEAR(found[n] / exact[n], 1.0, 1e-3) << n;
}

/// Displacement u_r of a disc of plane stress, held at its bore and free at its rim, over rho Omega^2 / E.
double disc_displacement(double r, double a, double b, double poisson) {
  // u = C r + D / r - (1 - nu^2) r^3 / 8; u(a) = 0, and sigma_r(b) = 0:
  // C (1 + nu) - D (1 - nu) / b^2 = (1 - nu^2) (3 + nu) b^2 / 8.
  const double p = 1 - poisson * poisson;
  Eigen::Matrix2d A;
  A << a, 1 / a, 1 + poisson, -(1 - poisson) / (b * b);
  const Eigen::Vector2d c = A.partialPivLu().solve(Eigen::Vector2d(p * a * a * a / 8, p * (3 + poisson) * b * b / 8));
  return c[0] * r + c[1] / r - p * r * r * r / 8;
}

TEST(AnnularPlate, GrowsUnderSpinAsADiscDoes) {
  TestRotor rotor = plate();
  const double speed = 600.0;
  const int node = rotor.dofs().contact.front();
  const Material steel = test::steel();
  const double exact = steel.density * speed * speed / steel.young * disc_displacement(0.2, 0.1, 0.2, steel.poisson);
  const Eigen::Vector3d at = rotor.mesh().nodes.col(node);
  const Eigen::Vector3d moved = cylindrical_frame(at).transpose() * rotor.static_displacement(speed).col(node);
  EXPECT_NEAR(moved[0] / exact, 1.0, 1e-3);
}

}  // namespace
}  // namespace tiprub::reduce
