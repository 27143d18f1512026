// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/reduced_model.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <ostream>

#include "tests/cases/complaint.h"
#include "tests/reduce/model/some_model.h"

namespace tiprub::reduce {
namespace {

/// A change of the model and the phrase that must come out.
struct Wrong {
  std::string name;
  std::function<void(ReducedModel&)> change;
  std::string phrase;
};
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.name;
}

/// Another contact node at the same place, with the arc length of a splitter.
void add_node(ReducedModel& m) {
  for (auto* table : {&m.contact.position, &m.contact.normal, &m.contact.static_shift[1], &m.contact.static_shift[2]})
    *table = table->replicate(2, 1).eval();
  m.contact.arc_length = Eigen::Vector2d::Zero();
}

class WrongModel : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongModel, IsRefused) {
  ReducedModel model = test::some_model();
  EXPECT_NO_THROW(check(model, "model.h5"));
  GetParam().change(model);
  const std::string message = complaint<RunError>([&] { check(model, "model.h5"); });
  EXPECT_EQ(message.rfind("model.h5: ", 0), 0u) << message;
  EXPECT_NE(message.find(GetParam().phrase), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Message, WrongModel,
    ::testing::Values(
        Wrong{"not_hermitian", [](ReducedModel& m) { m.nodal_diameters[1].K[1](0, 1) = 1e-3; },
              "/nodal_diameter/1/K1 is not Hermitian"},
        Wrong{"transpose_only",
              [](ReducedModel& m) { m.nodal_diameters[1].K[0](4, 0) = m.nodal_diameters[1].K[0](0, 4); },
              "/nodal_diameter/1/K0 is not Hermitian"},
        Wrong{"complex_standing_wave",
              [](ReducedModel& m) {
                m.nodal_diameters[2].K[0](0, 1) = {0.0, 1e3};
                m.nodal_diameters[2].K[0](1, 0) = {0.0, -1e3};
              },
              "/nodal_diameter/2/K0 must be real: this nodal diameter is a standing wave"},
        Wrong{"no_contact_mass", [](ReducedModel& m) { m.nodal_diameters[0].M(1, 1) = 0.0; },
              "/nodal_diameter/0/M has no mass in contact dof 1"},
        Wrong{"indefinite_mass", [](ReducedModel& m) { m.nodal_diameters[0].M(4, 4) = -1.0; },
              "/nodal_diameter/0/M is not positive definite"},
        Wrong{"too_small", [](ReducedModel& m) { m.nodal_diameters[0].M = Eigen::MatrixXcd::Identity(2, 2); },
              "/nodal_diameter/0/M is 2 x 2, but the contact nodes alone have 3 dofs"},
        Wrong{"shapes_differ", [](ReducedModel& m) { m.nodal_diameters[2].K[2] = Eigen::MatrixXcd::Zero(4, 5); },
              "/nodal_diameter/2/K2 is 4 x 5, must be 5 x 5"},
        Wrong{"long_normal", [](ReducedModel& m) { m.contact.normal *= 2; },
              "/contact/normal: row 0 is not of unit length"},
        // Symptom: a casing inside the wheel, angles in degrees, and verified frequencies below 0 passed without a
        // word.
        Wrong{"normal_inward", [](ReducedModel& m) { m.contact.normal *= -1; },
              "/contact/normal has the mean radial component -0.6, must be above -0.1: normals point from the "
              "blade to"},
        Wrong{"radius_zero", [](ReducedModel& m) { m.contact.position(0, 0) = 0; }, "row 0 has r = 0 m"},
        Wrong{"degrees", [](ReducedModel& m) { m.contact.position(0, 1) = 20; }, "theta = 20 rad; r must be above 0"},
        Wrong{"one_place_twice",
              [](ReducedModel& m) {
                add_node(m);
                m.contact.splitter_nodes = 1;
              },
              "/contact/position: rows 0 and 1 are the same place"},
        Wrong{"verified_speeds_descend", [](ReducedModel& m) { m.verification.speeds.reverseInPlace(); },
              "/verification/speed must begin at 0 or above, and ascend"},
        Wrong{"verified_below_zero", [](ReducedModel& m) { m.verification.unreduced[2](1, 0) = -3; },
              "/verification/nodal_diameter/2/unreduced holds -3 Hz, must be above 0"},
        Wrong{"no_contact", [](ReducedModel& m) { m.contact.arc_length.resize(0); }, "/contact holds no node"},
        Wrong{"table_too_long", [](ReducedModel& m) { m.contact.position = Eigen::MatrixX3d::Ones(2, 3); },
              "every table must have 1 rows"},
        Wrong{"arc_goes_back",
              [](ReducedModel& m) {
                const Eigen::RowVector3d normal = m.contact.normal;
                for (auto* table :
                     {&m.contact.position, &m.contact.normal, &m.contact.static_shift[1], &m.contact.static_shift[2]})
                  *table = normal.replicate(2, 1);
                m.contact.arc_length = Eigen::Vector2d(0.1, 0.0);
                for (auto& n : m.nodal_diameters)
                  for (auto* matrix : {&n.K[0], &n.K[1], &n.K[2], &n.M}) *matrix = Eigen::MatrixXcd::Identity(6, 6);
              },
              "/contact/arc_length must increase from the leading edge"},
        Wrong{"no_sectors", [](ReducedModel& m) { m.sector_count = 0; }, "sector_count must be at least 1"},
        Wrong{"a_block_too_few", [](ReducedModel& m) { m.nodal_diameters.pop_back(); },  // of Bdiag, eq. 12
              "has 2 nodal diameters, must have 3 for 4 sectors"},
        Wrong{"negative_speed", [](ReducedModel& m) { m.speed_max = -1.0; }, "speed_max must be at least 0"},
        Wrong{"negative_imbalance", [](ReducedModel& m) { m.verification.shape_balance->imbalance = -1; },
              "/verification: shape_imbalance and shape_tolerance must be at least 0"},
        Wrong{"verification_shape", [](ReducedModel& m) { m.verification.reduced[1].resize(1, 4); },
              "/verification/nodal_diameter/1/reduced is 1 x 4, must be 2 x 4"},
        Wrong{"verification_without_modes",
              [](ReducedModel& m) {
                m.verification.unreduced[1].resize(2, 0);
                m.verification.reduced[1].resize(2, 0);
              },
              "/verification/nodal_diameter/1/unreduced is 2 x 0, must be 2 x at least 1"}),
    [](const auto& wrong) { return wrong.param.name; });

/// A frame may be turned, and atan2 jumps from pi to -pi.
TEST(ReducedModel, MayStandAtAnyAngleOfATurn) {
  ReducedModel model = test::some_model();
  for (const double angle : {3.0, -3.0, 6.2}) {
    model.contact.position(0, 1) = angle;
    EXPECT_NO_THROW(check(model, "model.h5"));
  }
}

/// Symptom: a shape under spin that left 65 % of the load out of balance was named by reduce alone, and by no stage
/// that read its model.
TEST(ReducedModel, SaysWhatMakesItsResultsDoubtful) {
  ReducedModel model = test::some_model();
  EXPECT_EQ(doubts(model),
            "warning: frequencies of the model are off by up to 1 % at 0 rpm; raise fixed_interface_modes and "
            "modes_at_speed, or lower frequency_tolerance; ");
  model.verification.reduced = model.verification.unreduced;
  EXPECT_EQ(doubts(model), "");
  model.verification.shape_balance->imbalance = 0.65;
  EXPECT_EQ(doubts(model),
            "warning: the shape under spin leaves 65 % of the load out of balance between its speeds, more than "
            "polynomial_tolerance (0.01 %); ");
  model.verification.shape_balance.reset();
  model.contact.static_shift.terms[0] = Eigen::RowVector3d(0.01 / (model.speed_max * model.speed_max), 0, 0);
  EXPECT_EQ(doubts(model).rfind("warning: spin moves the tip by 0.01 m at 11788.6 rpm, 10 % of its radius: ", 0), 0u);
}

/// Symptom: a speed beyond those of the model was verified, and reduce warned of what eq. 7 misses there.
TEST(ReducedModel, HoldsNoFartherThanItsSpeeds) {
  ReducedModel model = test::some_model();
  EXPECT_EQ(polynomial_misfit(model), std::nullopt);
  model.verification.speeds[1] = 1.3 * model.speed_max;
  model.verification.polynomial_misfit.setConstant(2, 3, 1e-5);
  model.verification.polynomial_misfit(1, 2) = 0.05;
  EXPECT_EQ(polynomial_misfit(model), 1e-5);
  EXPECT_EQ(effects_of(model)[1].size, 1e-5);
  model.verification.reduced = model.verification.unreduced;
  EXPECT_EQ(doubts(model), "");
  model.verification.speeds[1] = model.speed_max;
  EXPECT_NE(doubts(model).find("frequencies are off by up to 5 %"), std::string::npos);
}

TEST(NodalDiameterModel, ItsStiffnessIsAPolynomialOfTheSpeedSquared) {
  // eq. 11, one block, and a term more than the paper has.
  const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(1, 1);
  const NodalDiameterModel model{{{4.0 * one, -1.0 * one, 0.5 * one, 0.25 * one}}, one};
  EXPECT_EQ(model.stiffness(0.0)(0, 0), 4.0);
  EXPECT_EQ(model.stiffness(2.0)(0, 0), 4.0 - 4.0 + 0.5 * 16 + 0.25 * 64);
}

TEST(ContactLine, IsShiftedByAPolynomialOfTheSpeedSquared) {
  ContactLine line;
  line.static_shift.terms = {Eigen::RowVector3d(1.0, 0.0, 2.0), Eigen::RowVector3d(0.0, -1.0, 0.5),
                             Eigen::RowVector3d(0.25, 0.0, 0.0), Eigen::RowVector3d(0.0, 0.125, 0.0)};
  EXPECT_EQ(line.static_shift(2.0), Eigen::MatrixX3d(Eigen::RowVector3d(4 + 16, -16 + 32, 8 + 8)));
}

TEST(NodalDiameterModel, AnUnstableRotorHasANegativeFrequency) {
  const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(1, 1);
  const NodalDiameterModel model{{{4.0 * one, -1.0 * one}}, one};
  EXPECT_NEAR(model.natural_frequencies(0.0)[0], 2 / (2 * std::numbers::pi), 1e-15);
  EXPECT_NEAR(model.natural_frequencies(3.0)[0], -std::sqrt(5.0) / (2 * std::numbers::pi), 1e-15);
}

}  // namespace
}  // namespace tiprub::reduce
