// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/rotating_elasticity.h"

#include <gtest/gtest.h>

#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::rotating_elasticity_test {
namespace {

using test::dense;
using test::TestRotor;

/// A sector that nothing holds, with every mesh node in its matrices.
class FreeSector : public ::testing::TestWithParam<int> {
 protected:
  FreeSector() : rotor_(test::tip_rotor(annulus())), volume_(rotor_.elasticity().volume()) {}

  static test::Annulus annulus() {
    test::Annulus annulus = test::skewed_annulus(5);
    annulus.nodes_per_brick = GetParam();
    annulus.bore = test::Bore::free;
    return annulus;
  }
  /// Nodal values of a displacement field, as sector dofs (cylindrical components).
  template <class Field>
  Eigen::VectorXd nodal(const Field& field) const {
    Eigen::VectorXd values(rotor_.dofs().sector());
    for (int node = 0; node < rotor_.mesh().node_count(); ++node) {
      const Eigen::Vector3d at = rotor_.mesh().nodes.col(node);
      values.segment<3>(rotor_.dofs().first[node]) = cylindrical_frame(at).transpose() * Eigen::Vector3d(field(at));
    }
    return values;
  }
  Eigen::VectorXd linear(const Eigen::Matrix3d& gradient) const {
    return nodal([&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return gradient * x; });
  }
  Eigen::VectorXd shift(int direction) const {
    return nodal([=](const Eigen::Vector3d&) -> Eigen::Vector3d { return Eigen::Vector3d::Unit(direction); });
  }
  /// Integral of rho x_i x_j.
  Eigen::Matrix3d second_moment() {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    FiniteElements(rotor_.mesh()).visit([&](const CellPoints& points) {
      sum += test::steel().density * points.position * points.weight.asDiagonal() * points.position.transpose();
    });
    return sum;
  }

  TestRotor rotor_;
  double volume_;
};
INSTANTIATE_TEST_SUITE_P(Nodes, FreeSector, ::testing::Values(20, 27));

/// Strains xx, yy, zz, 2 xy, 2 yz, 2 zx of a symmetric tensor.
Eigen::Matrix<double, 6, 1> voigt(const Eigen::Matrix3d& e) {
  return (Eigen::Matrix<double, 6, 1>() << e(0, 0), e(1, 1), e(2, 2), 2 * e(0, 1), 2 * e(1, 2), 2 * e(2, 0))
      .finished();
}

Eigen::Matrix3d symmetric(const Eigen::Matrix3d& H) {
  return 0.5 * (H + H.transpose());
}

Eigen::Matrix3d some_gradient() {
  return (Eigen::Matrix3d() << 1.0, 0.3, -0.2, 0.5, -0.7, 0.4, 0.1, 0.2, 0.6).finished();
}

TEST_P(FreeSector, HasTheSameMassInEveryDirection) {
  const Eigen::MatrixXd M = dense(rotor_.mass());
  const double mass = test::steel().density * volume_;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(shift(a).dot(M * shift(b)), a == b ? mass : 0.0, 1e-12 * mass);
}

TEST_P(FreeSector, HasTheMassMomentsOfItsShape) {
  // v = G x: v' M v = int rho |G x|^2 = tr(G J G').
  const Eigen::MatrixXd M = dense(rotor_.mass());
  const Eigen::Matrix3d G = some_gradient();
  const double exact = (G * second_moment() * G.transpose()).trace();
  EXPECT_NEAR(linear(G).dot(M * linear(G)), exact, 1e-12 * exact);
}

TEST_P(FreeSector, FeelsNoForceFromRigidMotionsAtRest) {
  const Eigen::MatrixXd K = dense(rotor_.at_rest());
  const double scale = K.cwiseAbs().maxCoeff();
  for (int d = 0; d < 3; ++d) {
    EXPECT_LT((K * shift(d)).cwiseAbs().maxCoeff(), 1e-11 * scale);
    const Eigen::VectorXd turn =
        nodal([=](const Eigen::Vector3d& x) -> Eigen::Vector3d { return Eigen::Vector3d::Unit(d).cross(x); });
    EXPECT_LT((K * turn).cwiseAbs().maxCoeff(), 1e-11 * scale * turn.cwiseAbs().maxCoeff());
  }
}

TEST_P(FreeSector, HasNoSoftModesBesidesTheSixRigidOnes) {
  const Eigen::VectorXd eigenvalues = test::generalized_eigenvalues(dense(rotor_.at_rest()), dense(rotor_.mass()));
  EXPECT_LT(eigenvalues.head(6).cwiseAbs().maxCoeff(), 1e-9 * eigenvalues[6]);
}

TEST_P(FreeSector, PassesThePatchTest) {
  // A uniform strain: no force on inner nodes, and the energy V E:C:E.
  const Eigen::Matrix3d H = some_gradient();
  const Eigen::MatrixXd K = dense(rotor_.at_rest());
  const Eigen::VectorXd u = linear(H), force = K * u;
  const auto strain = voigt(symmetric(H));
  const double energy = volume_ * strain.dot(test::steel().elasticity() * strain);
  EXPECT_NEAR(u.dot(force), energy, 1e-11 * energy);
  // The middle brick corner of the 2 x 2 x 1 bricks lies on the surface; refine axially for a node inside.
  test::Annulus finer = annulus();
  finer.bricks = {2, 2, 2};
  TestRotor inner(test::tip_rotor(finer));
  const test::BrickGrid grid(finer.bricks, finer.nodes_per_brick, test::Around::open);
  Eigen::VectorXd stretched(inner.dofs().sector());
  for (int node = 0; node < inner.mesh().node_count(); ++node) {
    const Eigen::Vector3d at = inner.mesh().nodes.col(node);
    stretched.segment<3>(inner.dofs().first[node]) = cylindrical_frame(at).transpose() * (H * at);
  }
  const Eigen::VectorXd forces = dense(inner.at_rest()) * stretched;
  EXPECT_LT(forces.segment<3>(inner.dofs().first[grid.node(2, 2, 2)]).norm(), 1e-11 * forces.cwiseAbs().maxCoeff());
}

TEST_P(FreeSector, SoftensUnderSpinByItsMassWithoutTheAxis) {
  // K(Omega) at zero displacement minus K(0) is -Omega^2 M_perp, and M_perp is M with its axial rows and columns out.
  const double speed = 3000.0;
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, rotor_.mesh().node_count());
  Eigen::MatrixXd perp = dense(rotor_.mass());
  for (int dof = 2; dof < rotor_.dofs().sector(); dof += 3) {
    perp.row(dof).setZero();
    perp.col(dof).setZero();
  }
  for (const Prestress prestress : {Prestress::stress_only, Prestress::linear}) {
    const Eigen::MatrixXd change =
        dense(rotor_.elasticity().stiffness(speed, still, prestress)) - dense(rotor_.at_rest());
    const double rounding = 1e-15 * dense(rotor_.at_rest()).cwiseAbs().maxCoeff();
    EXPECT_LT((change + speed * speed * perp).cwiseAbs().maxCoeff(),
              1e-13 * speed * speed * perp.maxCoeff() + rounding);
  }
}

TEST_P(FreeSector, ChangesItsStiffnessAsItsTangentDoes) {
  // The tangent stiffness is quadratic in the displacement u, so that (K(u) - K(-u)) / 2 is its derivative along u.
  // For the shape under spin it holds K_sigma.
  const Eigen::Matrix3Xd spin = rotor_.static_displacement(3000.0);
  const auto& nodes = rotor_.mesh().nodes;
  const std::vector<Eigen::Matrix3Xd> along = {spin, 1e-3 * nodes.array().sin().matrix()};
  const std::vector<Eigen::Matrix3Xd> shapes = {some_gradient() * nodes, (20 * nodes).array().cos().matrix()};
  const std::vector<Eigen::MatrixXd> changes = rotor_.elasticity().stiffness_change(along, shapes);
  ASSERT_EQ(changes.size(), along.size());
  const auto on_dofs = [&](const Eigen::Matrix3Xd& field) {
    Eigen::VectorXd values(rotor_.dofs().sector());
    for (int node = 0; node < rotor_.mesh().node_count(); ++node)
      values.segment<3>(rotor_.dofs().first[node]) =
          cylindrical_frame(rotor_.mesh().nodes.col(node)).transpose() * field.col(node);
    return values;
  };
  Eigen::MatrixXd phi(rotor_.dofs().sector(), 2);
  phi << on_dofs(shapes[0]), on_dofs(shapes[1]);
  for (std::size_t k = 0; k < along.size(); ++k) {
    const auto tangent = [&](double sign) {
      return dense(rotor_.elasticity().stiffness(0.0, sign * along[k], Prestress::nonlinear));
    };
    const Eigen::MatrixXd exact = phi.transpose() * ((tangent(1) - tangent(-1)) / 2) * phi;
    EXPECT_LT((changes[k] - exact).cwiseAbs().maxCoeff(), 1e-8 * exact.cwiseAbs().maxCoeff());
  }
}

TEST_P(FreeSector, TurnsRigidlyOnAnArc) {
  // No force holds (e^{bA} - 1) x, a turn by b. The second order in b is K'[A x] A x + K A^2 x = 0.
  const Eigen::Matrix3d A = (Eigen::Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 0).finished();
  const auto& nodes = rotor_.mesh().nodes;
  const Eigen::Matrix3Xd along = 1e-3 * (30 * nodes).array().sin().matrix();
  const Eigen::VectorXd psi =
      nodal([](const Eigen::Vector3d& x) -> Eigen::Vector3d { return 1e-3 * (30 * x).array().sin().matrix(); });
  const double change = rotor_.elasticity().stiffness_change({along}, {A * nodes})[0](0, 0);
  const double restoring = psi.dot(dense(rotor_.at_rest()) * linear(A * A));
  EXPECT_NEAR(change / restoring, -1.0, 1e-9);
}

TEST_P(FreeSector, IsLoadedByItsMassTimesRadius) {
  // f / Omega^2 = int rho N (x, y, 0): its sums are the first moments, its work on v = G x the second ones.
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  FiniteElements(rotor_.mesh()).visit([&](const CellPoints& points) {
    moment += test::steel().density * points.position * points.weight;
  });
  moment.z() = 0;
  const Eigen::VectorXd load = rotor_.elasticity().centrifugal_load();
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(load.dot(shift(d)), moment[d], 1e-12 * moment.norm());
  const Eigen::Matrix3d G = some_gradient(), J = second_moment();
  const double work = (G * J).topLeftCorner<2, 2>().trace() + 0.0;
  EXPECT_NEAR(load.dot(linear(G)), work, 1e-12 * std::abs(work));
}

TEST_P(FreeSector, IsStressedByAUniformStrainAsInClosedForm) {
  // At a uniform displacement gradient H, the work of v = G x is V (E':C:E' + S:(G'G)) with E' = sym(F'G), S = C:sym
  // H, and F = I + H (linear prestress) or I (stress only).
  const Eigen::Matrix3d H = 0.01 * some_gradient(), G = some_gradient().transpose();
  Eigen::Matrix3Xd stretched = H * rotor_.mesh().nodes;
  const double shear = test::steel().young / 2 / (1 + test::steel().poisson);
  const double lame = 2 * shear * test::steel().poisson / (1 - 2 * test::steel().poisson);
  const Eigen::Matrix3d S = lame * H.trace() * Eigen::Matrix3d::Identity() + 2 * shear * symmetric(H);
  for (const Prestress prestress : {Prestress::stress_only, Prestress::linear}) {
    Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
    if (prestress == Prestress::linear) F += H;
    const auto strain = voigt(symmetric(F.transpose() * G));
    const double exact =
        volume_ * (strain.dot(test::steel().elasticity() * strain) + (S * G.transpose() * G).trace());
    const Eigen::MatrixXd K = dense(rotor_.elasticity().stiffness(0.0, stretched, prestress));
    EXPECT_NEAR(linear(G).dot(K * linear(G)), exact, 1e-11 * exact);
  }
}

TEST(RotatingElasticity, ChangesWithSpeedAsThePolynomialSays) {
  // Linear prestress is quadratic in Omega^2, stress-only linear: eq. 7 through three speeds holds at any other.
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(5));
  const double top = 3000.0;
  for (const Prestress prestress : {Prestress::stress_only, Prestress::linear}) {
    const auto K = [&](double fraction) { return dense(rotor.at_speed(fraction * top, prestress)); };
    // Lagrange's polynomials in s = (Omega/top)^2 on the nodes 0, 1/4, 1.
    const double s = 0.49;
    const Eigen::MatrixXd between = K(0.0) * (s - 0.25) * (s - 1) / 0.25 +
                                    K(0.5) * s * (s - 1) / (0.25 * (0.25 - 1)) + K(1.0) * s * (s - 0.25) / 0.75;
    const Eigen::MatrixXd change = K(0.7) - K(0.0);
    EXPECT_LT((K(0.7) - between).cwiseAbs().maxCoeff(), 1e-10 * change.cwiseAbs().maxCoeff());
    const Eigen::MatrixXd square_term = K(1.0) - 4 * K(0.5) + 3 * K(0.0);
    const double relative = square_term.cwiseAbs().maxCoeff() / change.cwiseAbs().maxCoeff();
    if (prestress == Prestress::stress_only)
      EXPECT_LT(relative, 1e-10);
    else
      EXPECT_GT(relative, 1e-5);  // or the test above would show nothing
  }
}

}  // namespace
}  // namespace tiprub::reduce::rotating_elasticity_test
