// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/reduction.h"

#include <gtest/gtest.h>

#include <numbers>

#include "reduce/model/reduced_model.h"
#include "reduce/sector/contact_line.h"
#include "tests/cases/complaint.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/split_cells.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::reduction_test {
namespace {

using test::cyclic;
using test::TestRotor;

constexpr int sectors = 5;

ReductionParameters parameters() {
  ReductionParameters p;
  p.material = test::steel();
  p.speed_max = 3000.0;
  p.contact_nodes = 2;
  p.fixed_interface_modes = 16;
  p.verification_speeds = {0.0, 0.3, 1.0};
  p.verification_modes = 6;
  p.verification_tolerance = 1e-9;
  p.frequency_tolerance = 1e-3;
  p.polynomial_tolerance = 1e-3;
  return p;
}

ReducedModel reduced(const ReductionParameters& of, ReductionReport& report) {
  return reduce(test::skewed_annulus(sectors).sector(), of, Progress::Shown::never, report, nullptr, test::alone());
}

TEST(Reduction, MakesAModelThatPassesItsOwnCheck) {
  ReductionReport report;
  const ReducedModel model = reduced(parameters(), report);
  EXPECT_NO_THROW(check(model, "model"));
  EXPECT_EQ(model.sector_count, sectors);
  EXPECT_EQ(model.nodal_diameters.size(), 3u);
  EXPECT_EQ(model.prestress, Prestress::linear);
  EXPECT_EQ(model.contact.size(), 2);
  ASSERT_TRUE(model.contact.second_order.has_value());
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(model.nodal_diameters[n].M.rows(), model.contact_dofs() + report.generalized_dofs[n]);
    EXPECT_EQ(report.generalized_dofs[n] + report.dropped[n], 16 + 16 + model.contact_dofs() + report.corrections[n]);
  }
}

TEST(Reduction, EstimatesTheErrorOfTheMeshOrSaysThatItCant) {
  ReductionReport report;
  EXPECT_TRUE(reduced(parameters(), report).mesh_error.has_value());
  EXPECT_FALSE(report.mesh_error_unknown);
  // Four wedges, whose few integration points make one of the modes softer than cubic wedges do.
  test::Annulus annulus;
  annulus.nodes_per_brick = 27;
  annulus.bricks = {1, 2, 1};
  ReductionParameters of = parameters();
  of.verification_modes = 8;
  const SectorMesh wedges = test::split(annulus.sector(), test::Split::wedge15);
  EXPECT_FALSE(reduce(wedges, of, Progress::Shown::never, report, nullptr, test::alone()).mesh_error.has_value());
  EXPECT_TRUE(report.mesh_error_unknown);
}

TEST(Reduction, TabulatesTheUnreducedSectorsFrequencies) {
  ReductionReport report;
  const ReducedModel model = reduced(parameters(), report);
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(sectors));
  for (Eigen::Index s = 0; s < model.verification.speeds.size(); ++s) {
    const double speed = model.verification.speeds[s];
    EXPECT_DOUBLE_EQ(speed, parameters().verification_speeds[s] * 3000.0);
    const SymmetricMatrix K = rotor.at_speed(speed, Prestress::linear), M = rotor.mass();
    for (int n = 0; n <= sectors / 2; ++n) {
      const Eigen::VectorXd squares =
          test::generalized_eigenvalues(cyclic(K, rotor.dofs(), sectors, n), cyclic(M, rotor.dofs(), sectors, n));
      for (int k = 0; k < 6; ++k) {
        const double exact = std::sqrt(squares[k]) / (2 * std::numbers::pi);
        EXPECT_NEAR(model.verification.unreduced[n](s, k) / exact, 1.0, 1e-9);
        EXPECT_NEAR(model.verification.reduced[n](s, k) / exact, 1.0, 5e-3);
        EXPECT_DOUBLE_EQ(model.verification.reduced[n](s, k), model.nodal_diameters[n].natural_frequencies(speed)[k]);
      }
    }
  }
  EXPECT_LT(model_error(model, 30).error, 5e-3);
}

TEST(Reduction, HoldsAtSpeedsItNeverSaw) {
  // 0.3 and 0.8 of the top speed, the first 50 frequencies of the wheel.
  ReductionParameters p = parameters();
  p.fixed_interface_modes = 40;
  p.verification_speeds = {0.3, 0.8};
  p.verification_modes = 12;
  ReductionReport report;
  EXPECT_LT(model_error(reduced(p, report), 50).error, 5e-3);
}

TEST(Reduction, CorrectsABasisThatMissesModesBetweenItsSpeeds) {
  ReductionParameters p = parameters();
  p.fixed_interface_modes = 12;
  p.verification_speeds = {0.15, 0.4, 0.6, 0.9};  // none of them is corrected
  ReductionReport report;
  p.frequency_tolerance = 1;
  const double without = model_error(reduced(p, report), 30).error;
  EXPECT_EQ(report.corrections, std::vector(3, 0));
  p.frequency_tolerance = 1e-6;
  const double with = model_error(reduced(p, report), 30).error;
  EXPECT_GT(*std::min_element(report.corrections.begin(), report.corrections.end()), 0);
  EXPECT_LT(with, 0.3 * without);
}

test::Annulus thin_cone() {
  test::Annulus cone;
  cone.bricks = {4, 2, 1};
  cone.height = 0.001;
  cone.coning = 0.03;
  return cone;
}

/// Spin flattens it. Entry by entry, eq. 7 through K itself was off by 27 % between its speeds: the stiff directions
/// turn with the sheet.
TEST(Reduction, HoldsBetweenItsSpeedsHoweverFarAThinSheetTurns) {
  ReductionParameters p = parameters();
  p.prestress = Prestress::nonlinear;
  p.polynomial_tolerance = 1e-4;
  p.verification_speeds = {0.1, 0.2, 0.3, 0.45, 0.55, 0.65, 0.8, 0.9};
  p.verification_modes = 8;
  p.frequency_tolerance = 1e-4;
  ReductionReport report;
  const ReducedModel model = reduce(thin_cone().sector(), p, Progress::Shown::never, report, nullptr, test::alone());
  EXPECT_LT(model_error(model, 40).error, 1e-3);
  EXPECT_LT(model.verification.polynomial_misfit.maxCoeff(), 1e-3);
}

TEST(Reduction, TakesAsManyTermsAsTheShapeUnderSpinAsksFor) {
  // A soft rotor that bends a lot under spin.
  ReductionParameters p = parameters();
  p.prestress = Prestress::nonlinear;
  p.material.young = 4e10;
  p.verification_speeds = {0.3, 0.6, 0.9};
  double before = 1;
  for (const int terms : {1, 2, 4}) {
    ReductionReport report;
    p.polynomial_speeds = terms + 1;
    const ReducedModel model = reduced(p, report);
    EXPECT_EQ(report.shape_terms, terms);
    EXPECT_EQ(model.nodal_diameters[1].K.terms.size(), 2 * terms + 1u);
    EXPECT_EQ(model.contact.static_shift.terms.size(), terms + 0u);
    EXPECT_NO_THROW(check(model, "model"));
    const double misfit = model.verification.polynomial_misfit.maxCoeff();
    EXPECT_LT(misfit, 0.2 * before);
    before = misfit;
  }
  ReductionReport report;
  p.polynomial_speeds = 0;
  p.polynomial_tolerance = 1e-2;
  reduced(p, report);
  const int loose = report.shape_terms;
  p.polynomial_tolerance = 1e-7;
  const ReducedModel model = reduced(p, report);
  EXPECT_GT(report.shape_terms, loose);
  ASSERT_TRUE(model.verification.shape_balance);
  EXPECT_LE(model.verification.shape_balance->imbalance, 1e-7);
}

TEST(Reduction, ShiftsTheContactNodesAsTheStaticsSay) {
  ReductionReport report;
  const ReducedModel model = reduced(parameters(), report);
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(sectors));
  const double speed = 1500.0;
  const Eigen::Matrix3Xd exact = rotor.static_displacement(speed);
  const Eigen::MatrixX3d shift = model.contact.static_shift(speed);
  for (int k = 0; k < 2; ++k) {
    const int node = rotor.dofs().contact[k];
    const Eigen::Vector3d turned = cylindrical_frame(rotor.mesh().nodes.col(node)) * shift.row(k).transpose();
    EXPECT_LT((turned - exact.col(node)).norm(), 1e-9 * exact.col(node).norm());
    EXPECT_GT(shift(k, 0), 0.0);  // outwards
  }
}

TEST(Reduction, IsTheSameEveryTime) {
  ReductionReport report;
  const ReducedModel once = reduced(parameters(), report), again = reduced(parameters(), report);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(once.nodal_diameters[n].K[2], again.nodal_diameters[n].K[2]);
    EXPECT_EQ(once.nodal_diameters[n].M, again.nodal_diameters[n].M);
  }
}

TEST(Reduction, StressOnlyIsAnotherModelOfItsOwnName) {
  ReductionParameters p = parameters();
  p.prestress = Prestress::stress_only;
  ReductionReport report;
  const ReducedModel model = reduced(p, report);
  EXPECT_EQ(model.prestress, Prestress::stress_only);
  const NodalDiameterModel& one = model.nodal_diameters[1];  // linear in Omega^2
  EXPECT_LT(std::pow(p.speed_max, 2) * one.K[2].cwiseAbs().maxCoeff(), 1e-8 * one.K[1].cwiseAbs().maxCoeff());
}

TEST(Reduction, NamesTheSpeedOfAnUnstableRotor) {
  ReductionParameters p = parameters();
  p.material.young = 1e8;
  p.speed_max = 6000.0;
  p.prestress = Prestress::stress_only;
  ReductionReport report;
  const std::string message = complaint<RunError>([&] { reduced(p, report); });
  EXPECT_EQ(message.rfind("at 57296 rpm: ", 0), 0u) << message;  // 6000 rad/s
  EXPECT_NE(message.find("not positive definite: the rotor is unstable"), std::string::npos) << message;
}

TEST(Reduction, NamesTheSpeedWhoseShapeItDoesNotFind) {
  ReductionParameters p = parameters();
  p.speed_max = 5000.0;
  p.prestress = Prestress::nonlinear;
  ReductionReport report;
  const std::string message = complaint<RunError>(
      [&] { reduce(thin_cone().sector(), p, Progress::Shown::never, report, nullptr, test::alone()); });
  EXPECT_EQ(message.rfind("at ", 0), 0u) << message;
  EXPECT_NE(message.find(" rpm: the shape under spin doesn't converge"), std::string::npos) << message;
}

/// The shape is found at any speed, but no polynomial of 8 terms goes through all: the rotor was called unstable.
TEST(Reduction, BlamesAShapeThatItsTermsDoNotFollow) {
  test::Annulus cone = thin_cone();
  cone.height = 0.002;
  ReductionParameters p = parameters();
  p.speed_max = 6000.0;
  p.prestress = Prestress::nonlinear;
  p.polynomial_tolerance = 1e-4;
  p.verification_speeds = {0.1, 0.2, 0.3, 0.45, 0.55, 0.65, 0.8, 0.9};
  ReductionReport report;
  const std::string message =
      complaint<RunError>([&] { reduce(cone.sector(), p, Progress::Shown::never, report, nullptr, test::alone()); });
  EXPECT_NE(message.find("or its shape changes too much for eq. 7: "), std::string::npos) << message;
}

TEST(Reduction, RefusesAModelSmallerThanItsVerification) {
  // Two modes and six contact dofs verified by 30 frequencies read beyond the model's own ones.
  ReductionParameters p = parameters();
  p.fixed_interface_modes = 2;
  p.verification_modes = 30;
  ReductionReport report;
  const std::string message = complaint<InputError>([&] { reduced(p, report); });
  EXPECT_NE(message.find("verification_modes = 30"), std::string::npos) << message;
}

TEST(Reduction, ChecksASectorWithoutReducingIt) {
  EXPECT_GT(check_sector(test::skewed_annulus(sectors).sector(), parameters()).mass, 0);
  SectorMesh mesh = test::skewed_annulus(sectors).sector();
  mesh.nodes.row(2) *= -1;
  EXPECT_NE(complaint<InputError>([&] { check_sector(mesh, parameters()); }), "");
}

TEST(VerificationError, CountsTravellingWavesTwice) {
  // Wheel of 3: n = 0 once at 10 Hz, n = 1 twice at 20 Hz, n = 0 again at 30 Hz.
  ReducedModel model;
  model.sector_count = 3;
  model.nodal_diameters.resize(2);
  model.verification.speeds = Eigen::VectorXd::Zero(1);
  model.verification.unreduced = {Eigen::RowVector2d(10.0, 30.0), Eigen::RowVector2d(20.0, 40.0)};
  model.verification.reduced = {Eigen::RowVector2d(10.0 * 1.01, 30.0 * 1.03), Eigen::RowVector2d(20.0 * 1.02, 40.0)};
  EXPECT_NEAR(model_error(model, 1).error, 0.01, 1e-14);
  EXPECT_NEAR(model_error(model, 3).error, 0.02, 1e-14);
  EXPECT_NEAR(model_error(model, 4).error, 0.03, 1e-14);
}

}  // namespace
}  // namespace tiprub::reduce::reduction_test
