// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "simulate/march/contact_compliance.h"
#include "simulate/march/second_order_terms.h"
#include "simulate/orbits/energy_audit.h"
#include "tests/simulate/one_sector.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::second_order_test {
namespace {

constexpr double radius = 0.1;  // m, of one_sector()
constexpr std::size_t width = 4;

/// One contact node whose blade has the coordinate y = u_theta, with a displacement Q y^2 along its normal.
ContactLine tip_that_turns(double Q, double curvature) {
  ContactLine tips = testing::one_sector().contact;
  tips.second_order.emplace();
  tips.second_order->curvature = Eigen::RowVector2d(curvature, 0);
  tips.second_order->coordinates = Eigen::Vector3d::UnitY();
  tips.second_order->displacement = {Eigen::MatrixXd::Constant(1, 1, Q)};
  return tips;
}

/// A tip on a rigid arc about the axis comes down by u^2/(2 r), as the casing does: in a round casing its gap stays.
/// In a lobed one, it is that of the turned casing, up to terms of third order.
TEST(SecondOrder, OfARigidTurnReadsTheCasingWhereTheTipIs) {
  const ContactLine tips = tip_that_turns(-1 / (2 * radius), 1 / radius);
  const double amplitude = 2e-4, y = 2e-3, angle = y / radius;
  for (const int lobes : {1, 3}) {
    const Obstacle obstacle(testing::lobed_casing(lobes, amplitude, 0), tips, Eigen::VectorXd::Zero(1));
    const int steps = 360;
    const SecondOrderTerms terms(tips, obstacle, steps, width);
    for (const std::int64_t phase : {0, 20, 47, 100}) {
      const double turn = 2 * std::numbers::pi * static_cast<double>(phase) / steps;
      const double narrowed = obstacle.distortion(0, turn + angle) - obstacle.distortion(0, turn);
      std::array<double, width> gap = {1e-3, 1, 1, 1};
      EXPECT_FALSE(terms.narrow(&y, {phase, 1}, gap.data()));
      EXPECT_NEAR(1e-3 - gap[0], narrowed, amplitude * std::pow(lobes * angle, 3) / 6 + 1e-13);
      gap[0] = 0.5e-9;
      EXPECT_FALSE(terms.narrow(&y, {phase, 0}, gap.data()));  // not grown: a round casing
      EXPECT_NEAR(gap[0], 0.5e-9, 1e-18);
    }
  }
}

TEST(SecondOrder, HasTheSlopesOfItsGap) {
  ReducedModel model = testing::synthetic_wheel({1, 3, 5});
  std::mt19937 source(3);
  const auto random = [&] { return 2.0 * source() / std::mt19937::max() - 1.0; };
  SecondOrderGap& given = model.contact.second_order.emplace();
  given.curvature = Eigen::MatrixX2d::NullaryExpr(3, 2, random) * 10;
  given.coordinates = Eigen::MatrixXd::NullaryExpr(9, 2, random);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Matrix2d any = Eigen::Matrix2d::NullaryExpr(random) * 10;
    given.displacement.emplace_back(any + any.transpose());
  }
  const Obstacle obstacle(testing::lobed_casing(2, 2e-4, 0), model.contact, Eigen::VectorXd::Zero(3));
  const SecondOrderTerms terms(model.contact, obstacle, 360, width);
  const SecondOrderTerms::Place place{31, 0.7};
  Eigen::Vector2d y(1.3e-3, -0.4e-3);
  Eigen::Matrix<double, width, 2> slopes;
  terms.slopes(y.data(), place, slopes.data(), width);
  const auto narrowed = [&](const Eigen::Vector2d& at) {
    Eigen::Vector4d gap = Eigen::Vector4d::Zero();
    terms.narrow(at.data(), place, gap.data());
    return (-gap).eval();
  };
  const double step = 1e-5;
  for (int a = 0; a < 2; ++a) {
    const Eigen::Vector2d along = step * Eigen::Vector2d::Unit(a);
    const Eigen::Vector4d difference = (narrowed(y + along) - narrowed(y - along)) / (2 * step);
    EXPECT_LT((difference - slopes.col(a)).cwiseAbs().maxCoeff(), 1e-10);
  }
}

/// A blade of two modes, of which the second moves its tip mainly along theta.
RotorAtSpeed two_modes(double damping_ratio) {
  RotorAtSpeed rotor;
  rotor.speed = 1000;
  rotor.sector_count = 1;
  WaveModes wave;
  wave.kind = WaveKind::standing;
  wave.moving = 2;
  wave.omega = Eigen::Array2d(9000, 5000);
  wave.damping_ratio = Eigen::Array2d::Constant(damping_ratio);
  wave.normal_rows = Eigen::RowVector2cd(2, 0.4);
  wave.blade_rows = Eigen::RowVector2cd(0.3, 6);
  wave.sliding_rows = Eigen::MatrixXcd::Zero(2, 2);
  wave.sliding_rows.row(0) = wave.blade_rows;
  wave.contact_rows = Eigen::MatrixXcd::Zero(3, 2);
  wave.shapes = Eigen::MatrixXcd::Identity(2, 2);
  rotor.waves.push_back(wave);
  rotor.omega_max = 9000;
  return rotor;
}

MarchSetup curved(Scheme scheme, int steps) {
  MarchSetup setup{scheme, ContactRule::complementarity, steps};
  setup.gap = GapOrder::second_order;
  return setup;
}

/// A blade that flies against a spring along its normal, in a round casing: the sum of its energy and the spring's
/// stays, up to the square of the step. With forces along the normal alone, it does not.
TEST(SecondOrder, ConservesTheEnergyOfABladeOnASpring) {
  const double stiffness = 4e7, clearance = 2e-5;  // [N/m], [m]
  const auto drift = [&](int steps) {
    MarchSetup setup = curved(Scheme::penalty, steps);
    setup.penalty_stiffness = stiffness;
    TimeMarch march = testing::march_of(two_modes(0), testing::lobed_casing(1, 0, 0), tip_that_turns(-8, 10),
                                        Eigen::VectorXd::Constant(1, clearance), setup);
    march.set_state(0, Eigen::Vector2cd(0, -3e-4), Eigen::Vector2cd(0, 0));
    double least = HUGE_VAL, most = 0, deepest = 0;
    for (int i = 0; i < 10 * steps; ++i) {
      march.step();
      const Eigen::ArrayXd q = march.coordinates(0).real.head(2), d = march.increments(0).real.head(2),
                           middle = q - d / 2;
      const Eigen::Array2d omega(9000, 5000);
      const double depth = std::max(0.0, -(march.gap()[0] + march.gaps().now[0]) / 2);
      const double energy =
          ((d / march.time_step()).square() + (omega * middle).square()).sum() / 2 + stiffness * depth * depth / 2;
      least = std::min(least, energy);
      most = std::max(most, energy);
      deepest = std::max(deepest, depth);
    }
    EXPECT_GT(deepest, 1e-5);
    return (most - least) / most;
  };
  const double coarse = drift(4000), fine = drift(8000);
  EXPECT_LT(fine, 0.005);
  EXPECT_NEAR(coarse / fine, 4, 1.5);
}

/// Impacts without rebound and closed contact only take energy, and what they take is in the ledger.
TEST(SecondOrder, OnlyTakesEnergyInARoundCasing) {
  for (const Scheme scheme : {Scheme::trigonometric, Scheme::central_differences, Scheme::moreau_jean}) {
    TimeMarch march = testing::march_of(two_modes(0), testing::lobed_casing(1, 0, 0), tip_that_turns(-8, 10),
                                        Eigen::VectorXd::Constant(1, 2e-5), curved(scheme, 8000));
    march.set_state(0, Eigen::Vector2cd(0, -3e-4), Eigen::Vector2cd(0, 0));
    EnergyAudit audit(march);
    double before = 0, rise = 0, largest = 0;
    for (int i = 0; i < 5 * 8000; ++i) {
      march.step();
      audit.observe(march);
      const double change = audit.ledger(march).energy_change;
      rise += std::max(0.0, change - before);
      largest = std::max(largest, std::abs(change));
      before = change;
    }
    EXPECT_GT(largest, 0);
    EXPECT_LT(rise, 0.02 * largest) << static_cast<int>(scheme);
    EXPECT_LT(std::abs(audit.ledger(march).closing_error), 1e-9);
  }
}

/// Two sectors of four nodes and four coordinates: W of forces along n + G y, from rows of the displacements in some
/// modes.
TEST(SecondOrder, HasTheComplianceOfForcesAlongItsSlopes) {
  std::mt19937 source(11);
  const auto random = [&] { return 2.0 * source() / std::mt19937::max() - 1.0; };
  const Eigen::Index nodes = 8, modes = 12;
  const Eigen::MatrixXd Y = Eigen::MatrixXd::NullaryExpr(nodes, modes, random),
                        B = Eigen::MatrixXd::NullaryExpr(8, modes, random);
  Eigen::MatrixXd both(nodes + 8, modes);
  both << Y, B;
  ContactCompliance compliance(ContactCompliance::Responses{both * Y.transpose(), {}, both * B.transpose(), {}, 2});
  EXPECT_FALSE(compliance.is_constant());
  for (int step = 0; step < 2; ++step) {
    Eigen::MatrixXd& slopes = compliance.tilt();
    slopes = Eigen::MatrixXd::NullaryExpr(nodes, 4, random);
    Eigen::MatrixXd directions = Y;
    for (Eigen::Index i = 0; i < nodes; ++i) directions.row(i) += slopes.row(i) * B.middleRows(i / 4 * 4, 4);
    const std::vector<int> closed = {0, 2, 7};
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(nodes, 3);  // whole vectors of eight
    compliance.block(closed, columns.data());
    const Eigen::MatrixXd of_closed = directions(closed, Eigen::all), block = of_closed * of_closed.transpose();
    EXPECT_LT((columns.topRows(3) - block).triangularView<Eigen::Lower>().toDenseMatrix().norm(), 1e-12);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(nodes);
    forces(closed) = Eigen::Vector3d(3, 2, 5);
    compliance.respond(forces, closed);
    const Eigen::Map<const Eigen::VectorXd> opened(compliance.opened(), nodes);
    EXPECT_LT((opened - directions * directions.transpose() * forces).norm(), 1e-12);
    EXPECT_LT((compliance.normal_response() - Y * directions.transpose() * forces).norm(), 1e-12);
    EXPECT_LT((compliance.blade_response() - B * directions.transpose() * forces).norm(), 1e-12);
  }
}

/// Schemes with steps of their own, on a motion that the second order changes by more than they differ.
TEST(SecondOrder, IsTheSameWithOtherSchemes) {
  const ReducedModel model = testing::curved_wheel();
  const auto amplitude = [&](Scheme scheme, int steps, GapOrder gap) {
    MarchSetup setup = curved(scheme, steps);
    setup.gap = gap;
    setup.symmetry = 2;
    return testing::settled_amplitude(
        testing::make_bench(model, testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.05, setup));
  };
  const double expected = amplitude(Scheme::trigonometric, 9600, GapOrder::second_order);
  EXPECT_GT(std::abs(amplitude(Scheme::trigonometric, 9600, GapOrder::linear) / expected - 1), 0.02);
  EXPECT_NEAR(amplitude(Scheme::trigonometric, 4800, GapOrder::second_order) / expected, 1, 0.005);
  for (const Scheme scheme : {Scheme::central_differences, Scheme::moreau_jean})
    EXPECT_NEAR(amplitude(scheme, 9600, GapOrder::second_order) / expected, 1, 0.005) << static_cast<int>(scheme);
}

/// The symmetric nodal diameters alone against the whole wheel, transient included.
TEST(SecondOrder, KeepsTheSymmetryOfTheWheel) {
  const ReducedModel model = testing::curved_wheel();
  const Casing casing = testing::lobed_casing(2, 2e-4, 1.5e-4);
  MarchSetup setup = curved(Scheme::trigonometric, 1200);
  testing::Bench whole = testing::make_bench(model, casing, 900, 0.01, setup);
  setup.symmetry = 2;
  testing::Bench part = testing::make_bench(model, casing, 900, 0.01, setup);
  setup.gap = GapOrder::linear;
  testing::Bench linear = testing::make_bench(model, casing, 900, 0.01, setup);
  double difference = 0, to_linear = 0, largest = 0;
  for (int i = 0; i < 4 * 1200; ++i) {
    whole.march.step();
    part.march.step();
    linear.march.step();
    const Eigen::VectorXd repeated = part.march.displacement().replicate(2, 1);
    difference = std::max(difference, (whole.march.displacement() - repeated).cwiseAbs().maxCoeff());
    to_linear = std::max(to_linear, (part.march.displacement() - linear.march.displacement()).cwiseAbs().maxCoeff());
    largest = std::max(largest, repeated.cwiseAbs().maxCoeff());
  }
  EXPECT_LT(difference, 1e-9 * largest);
  EXPECT_GT(to_linear, 0.01 * largest);
}

}  // namespace
}  // namespace tiprub::simulate::second_order_test
