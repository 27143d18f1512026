// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/spin_equilibrium.h"

#include <gtest/gtest.h>

#include "reduce/reduction.h"
#include "tests/cases/complaint.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::spin_equilibrium_test {
namespace {

using test::dense;
using test::TestRotor;

constexpr double top = 3000.0;  // [rad/s]
constexpr int sectors = 5;

/// A rotor with what an equilibrium needs.
class Spinning : public ::testing::Test {
 protected:
  Spinning()
      : rotor_(test::tip_rotor(test::skewed_annulus(sectors), soft())),
        factor_(rotor_.at_rest(), rotor_.dofs()),
        at_rest_(factor_, CyclicTransformation(rotor_.dofs(), sectors, 0)) {}
  /// A tenth of steel's stiffness, so that the shape changes visibly.
  static Material soft() {
    Material material = test::steel();
    material.young /= 10;
    return material;
  }
  SpinEquilibrium at(double speed) {
    return spin_equilibrium({rotor_.elasticity(), rotor_.mesh(), at_rest_}, speed,
                            Eigen::VectorXd::Zero(rotor_.dofs().sector()));
  }
  Eigen::Matrix3Xd displacement(const Eigen::VectorXd& u) const {
    return cartesian_displacement(rotor_.mesh(), rotor_.dofs(), u);
  }
  /// Forces on the independent dofs.
  Eigen::VectorXd gather(const Eigen::VectorXd& sector) const {
    return at_rest_.transform().gather(sector.cast<std::complex<double>>()).real();
  }
  /// Some vector of sector dofs, the same every time.
  Eigen::VectorXd some_shape(double size) const {
    Eigen::VectorXd u(rotor_.dofs().sector());
    for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = size * std::sin(1.0 + 0.7 * static_cast<double>(i * i % 101));
    return u;
  }

  TestRotor rotor_;
  SectorFactor factor_;
  CyclicSolver at_rest_;
};

TEST_F(Spinning, IsInBalance) {
  const SpinEquilibrium found = at(top);
  const Eigen::Matrix3Xd u = displacement(found.displacement);
  const Eigen::VectorXd load = gather(top * top * rotor_.elasticity().centrifugal_load(u));
  const Eigen::VectorXd internal = gather(rotor_.elasticity().internal_force(u));
  EXPECT_LT((load - internal).norm(), 1e-8 * load.norm());
  EXPECT_GE(found.iterations, 3);
  EXPECT_LE(found.iterations, 6);
  EXPECT_LE(found.residual, 1e-10);
}

TEST_F(Spinning, IsNotAtTheLinearShape) {
  const Eigen::VectorXd found = at(top).displacement;
  const Eigen::VectorXd linear = (at(1e-2 * top).displacement * 1e4).eval();
  EXPECT_GT((found - linear).norm(), 1e-2 * linear.norm());
}

TEST_F(Spinning, ApproachesTheLinearShapeWithTheSquareOfSpeed) {
  // u / Omega^2 differs from the linear one by the order of Omega^2.
  const auto error = [&](double speed) {
    const Eigen::Matrix3Xd linear = rotor_.static_displacement(speed);
    return (displacement(at(speed).displacement) - linear).norm() / linear.norm();
  };
  EXPECT_NEAR(std::log2(error(top / 20) / error(top / 40)), 2.0, 0.02);
}

TEST_F(Spinning, HasTheTangentOfItsForces) {
  // K_T v = d/de (f_int - Omega^2 f)(u + e v), by central differences: cubic functions, so one step halving cancels
  // their error exactly up to rounding.
  const Eigen::VectorXd u = some_shape(1e-3), v = some_shape(1.0).reverse();
  const auto forces = [&](double e) -> Eigen::VectorXd {
    const Eigen::Matrix3Xd moved = displacement(u + e * v);
    return rotor_.elasticity().internal_force(moved) - top * top * rotor_.elasticity().centrifugal_load(moved);
  };
  const auto slope = [&](double e) -> Eigen::VectorXd { return (forces(e) - forces(-e)) / (2 * e); };
  const double step = 1e-3;
  const Eigen::VectorXd differences = (4 * slope(step / 2) - slope(step)) / 3;
  const Eigen::VectorXd tangent =
      dense(rotor_.elasticity().stiffness(top, displacement(u), Prestress::nonlinear)) * v;
  EXPECT_LT((tangent - differences).norm(), 1e-9 * tangent.norm());
}

TEST_F(Spinning, FeelsNoStressFromATurn) {
  // Objectivity: a rigid turn strains nothing, however large.
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()));
  const Eigen::Matrix3Xd turned = turn * rotor_.mesh().nodes - rotor_.mesh().nodes;
  const double scale = dense(rotor_.at_rest()).cwiseAbs().maxCoeff() * turned.cwiseAbs().maxCoeff();
  EXPECT_LT(rotor_.elasticity().internal_force(turned).cwiseAbs().maxCoeff(), 1e-12 * scale);
}

TEST_F(Spinning, HasNoShapeBeyondItsStability) {
  EXPECT_NE(complaint<RunError>([&] { at(30 * top); }), "");
}

ReductionParameters nonlinear_parameters() {
  ReductionParameters p;
  p.material = test::steel();
  p.prestress = Prestress::nonlinear;
  p.speed_max = top;
  p.contact_nodes = 2;
  p.fixed_interface_modes = 16;
  p.verification_speeds = {0.0, 0.5, 0.75, 1.0};
  p.verification_modes = 6;
  p.verification_tolerance = 1e-9;
  p.polynomial_tolerance = 1e-4;
  return p;
}

TEST(NonlinearReduction, StatesTheMisfitOfItsPolynomial) {
  ReductionReport report;
  const ReducedModel model = reduce(test::skewed_annulus(sectors).sector(), nonlinear_parameters(),
                                    Progress::Shown::never, report, nullptr, test::alone());
  EXPECT_EQ(model.prestress, Prestress::nonlinear);
  EXPECT_NO_THROW(check(model, "model"));
  const Eigen::MatrixXd& misfit = model.verification.polynomial_misfit;
  ASSERT_EQ(misfit.rows(), 4);
  ASSERT_EQ(misfit.cols(), 3);
  for (const int exact : {0, 3}) EXPECT_LT(misfit.row(exact).maxCoeff(), 1e-9) << exact;
  for (const int between : {1, 2}) EXPECT_GT(misfit.row(between).maxCoeff(), 1e-11) << between;
  EXPECT_LT(misfit.maxCoeff(), 1e-4);
  ASSERT_TRUE(model.verification.shape_balance);
  EXPECT_LE(model.verification.shape_balance->imbalance, 1e-4);
  EXPECT_EQ(model.verification.shape_balance->tolerance, 1e-4);
  EXPECT_GE(report.newton_steps, 3);
  EXPECT_LE(report.newton_residual, 1e-10);
}

TEST(NonlinearReduction, ShiftsTheContactNodesAsTheEquilibriaDo) {
  ReductionParameters p = nonlinear_parameters();
  p.material.young /= 10;
  p.polynomial_tolerance = 1e-6;
  ReductionReport report;
  const ReducedModel model =
      reduce(test::skewed_annulus(sectors).sector(), p, Progress::Shown::never, report, nullptr, test::alone());
  EXPECT_GT(report.shape_terms, 2);
  EXPECT_EQ(model.contact.static_shift.terms.size(), report.shape_terms + 0u);
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(sectors), p.material);
  const SectorFactor factor(rotor.at_rest(), rotor.dofs());
  const CyclicSolver at_rest(factor, CyclicTransformation(rotor.dofs(), sectors, 0));
  for (const double fraction : {0.2, 0.55, 0.9, 1.0}) {
    const Eigen::VectorXd exact = spin_equilibrium({rotor.elasticity(), rotor.mesh(), at_rest}, fraction * top,
                                                   Eigen::VectorXd::Zero(rotor.dofs().sector()))
                                      .displacement;
    const Eigen::MatrixX3d shift = model.contact.static_shift(fraction * top);
    for (int k = 0; k < 2; ++k)
      EXPECT_LT((shift.row(k).transpose() - exact.segment<3>(rotor.dofs().first[rotor.dofs().contact[k]])).norm(),
                1e-6 * shift.row(k).norm());
  }
}

TEST(SpinSoftening, LowersFrequenciesAndCanBeLeftOut) {
  ReductionParameters p = nonlinear_parameters();
  p.prestress = Prestress::linear;
  ReductionReport report;
  const SectorMesh mesh = test::skewed_annulus(sectors).sector();
  const ReducedModel with = reduce(mesh, p, Progress::Shown::never, report, nullptr, test::alone());
  p.spin_softening = SpinSoftening::off;
  const ReducedModel without = reduce(mesh, p, Progress::Shown::never, report, nullptr, test::alone());
  EXPECT_EQ(without.prestress, Prestress::linear);
  EXPECT_EQ(without.spin_softening, SpinSoftening::off);
  const double at_rest = with.verification.unreduced[0](0, 0);
  EXPECT_NEAR(without.verification.unreduced[0](0, 0) / at_rest, 1.0, 1e-9);
  EXPECT_GT(without.verification.unreduced[0](3, 0), with.verification.unreduced[0](3, 0));
}

}  // namespace
}  // namespace tiprub::reduce::spin_equilibrium_test
