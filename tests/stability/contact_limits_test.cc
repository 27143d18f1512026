// SPDX-License-Identifier: GPL-3.0-or-later
// The contact problem: the paper's rule, too few modes, doubled nodes, grazing.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simulate/march/contact_impulses.h"
#include "simulate/motion/attempt.h"
#include "tests/stability/bench_scene.h"

namespace tiprub::simulate {
namespace {

constexpr double pi = std::numbers::pi;

SpeedResponse rub(ContactRule rule, int steps) {
  SimulateParameters parameters;
  parameters.scheme = Scheme::central_differences;
  parameters.contact = rule;
  const testing::OwnedScene scene =
      testing::owned_scene(testing::synthetic_wheel({}), testing::lobed_casing(2, 2e-4, 1.5e-4), steps, parameters);
  SpeedResponse at = simulate_speed(scene.view(), 900).response;
  EXPECT_EQ(at.failure, "");
  return at;
}

/// Whatever the step: the paper's rule pulls and leaves nodes in the casing, complementarity does neither.
TEST(PapersRuleLimit, PullsAndLeavesNodesInTheCasing) {
  for (int steps : {6000, 24000}) {
    const SpeedResponse inside = rub(ContactRule::complementarity, steps), outside = rub(ContactRule::paper, steps);
    EXPECT_EQ(inside.tension_steps, 0);
    EXPECT_EQ(inside.leftover_steps, 0);
    EXPECT_EQ(inside.tension_share, 0.0);
    EXPECT_GE(inside.smallest_multiplier, 0.0);
    EXPECT_LT(inside.largest_penetration, 1e-11 * 1.5e-4);
    EXPECT_GT(outside.tension_steps, 0) << steps;
    EXPECT_GT(outside.leftover_steps, 0) << steps;
    EXPECT_GT(outside.tension_share, 0.0);
    EXPECT_LT(outside.smallest_multiplier, 0.0);
    EXPECT_GT(outside.largest_penetration, 1e-8 * 1.5e-4);
  }
}

/// Share of the force that pulls, of the paper's rule in a march that the case file refuses.
double trigonometric_tension(int steps) {
  testing::Bench bench =
      testing::make_bench(testing::synthetic_wheel({6, 10, 5}), testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.01,
                          {Scheme::trigonometric, ContactRule::paper, steps, 1});
  double pull = 0, all = 0;
  for (int i = 0; i < 10 * steps; ++i) {
    bench.march.step();
    if (bench.march.contact().closed().empty()) continue;
    const Eigen::ArrayXd forces = bench.march.contact().multipliers().array();
    pull -= forces.min(0.0).sum();
    all += forces.abs().sum();
  }
  return pull / all;
}

/// Ten nodes a blade; h omega_max / 2 is 0.5 and 4.6.
TEST(PapersRuleLimit, IsWorseWithLargeTrigonometricSteps) {
  EXPECT_LT(trigonometric_tension(600), 2e-3);
  EXPECT_GT(trigonometric_tension(60), 2e-2);
}

SpeedResponse with_modes(Scheme scheme, int modes) {
  SimulateParameters parameters;
  parameters.scheme = scheme;
  parameters.modes = modes;
  const testing::OwnedScene scene = testing::owned_scene(testing::synthetic_wheel({6, 4, 5}),
                                                         testing::lobed_casing(1, 2e-4, 1.5e-4), 1200, parameters);
  return simulate_speed(scene.view(), 900).response;
}

/// Four contact nodes need four modes; with three no force closes them all.
TEST(FewModesLimit, IsTheNumberOfContactNodes) {
  EXPECT_EQ(with_modes(Scheme::trigonometric, 6).failure, "");
  const std::string refused = with_modes(Scheme::trigonometric, 3).failure;
  EXPECT_NE(refused.find("3 modes a nodal diameter can't move 4 contact nodes independently"), std::string::npos)
      << refused;
  EXPECT_NE(refused.find("residual_flexibility"), std::string::npos);
}

TEST(FewModesLimit, IsNoneWithResidualFlexibility) {
  double last = 1;
  for (int modes : {2, 6, 14}) {
    const SpeedResponse at = with_modes(Scheme::residual_flexibility, modes);
    EXPECT_EQ(at.failure, "");
    EXPECT_EQ(at.tension_steps, 0);
    EXPECT_LT(at.left_out_energy, last);
    EXPECT_GT(at.left_out_energy, 0);
    last = at.left_out_energy;
  }
}

/// A doubled node makes W singular: displacements stay what they were, and no step fails. A W with a truly negative
/// eigenvalue is none, and is said to be none.
TEST(DoubledNodesLimit, IsASemidefiniteCompliance) {
  const auto correction = [](double below) {
    Eigen::Matrix3d W;
    W << 1, 1, 0.3, 1, 1 - below, 0.3, 0.3, 0.3, 1;
    ContactImpulses contact(W, ContactRule::complementarity);
    Eigen::VectorXd gap = Eigen::Vector3d(-1, -1, -1);
    contact.solve(gap);
    EXPECT_LT(gap.cwiseAbs().maxCoeff(), 1e-10);
    return contact.correction()[0];
  };
  EXPECT_NEAR(correction(0.0), 1.0, 1e-10);
  EXPECT_THROW(correction(1e-6), NoMotion);
}

/// A mass swings and touches a wall at rest: what it is stopped by when the wall moves by a millionth of the swing.
double sensitivity(double wall_share) {
  constexpr double amplitude = 1e-3, stiffness = 1e4, mass = 0.01, omega = 1000, speed = 10;
  constexpr int steps = 6'000'000;  // a step must be short against sqrt(2 1e-6)/omega
  const auto swing = [&](double wall) {
    testing::Bench bench = testing::make_bench(testing::one_mass(mass, stiffness), testing::round_wall(wall), speed,
                                               0.0, {Scheme::trigonometric, ContactRule::complementarity, steps, 1});
    const Eigen::MatrixXd Y = bench.rotor.waves[0].normal_rows.real();
    const Eigen::VectorXd q = Y.transpose() / Y.squaredNorm() * amplitude;
    const double start = -1.0, h = bench.march.time_step();  // rad before the crest
    bench.march.set_state(0, (q * std::cos(start)).cast<std::complex<double>>(),
                          (q * (std::cos(start) - std::cos(start - omega * h))).cast<std::complex<double>>());
    for (int i = 0; i < 2.0 / omega / h; ++i) bench.march.step();
    const double now = bench.march.displacement()[0], before = bench.march.displacement_before()[0];
    return Eigen::Vector2d(now / amplitude, (now - before) / h / omega / amplitude);
  };
  return (swing(wall_share * amplitude) - swing((wall_share + 1e-6) * amplitude)).norm() / 1e-6;
}

TEST(GrazingLimit, IsSeenByMovingTheWallByAMillionth) {
  EXPECT_LT(sensitivity(0.6), 10);          // a firm impact: changes of the order of the disturbance
  EXPECT_GT(sensitivity(1.0 - 1e-6), 100);  // the crest just touches: of the order of its square root
  EXPECT_EQ(sensitivity(1.0 + 1e-5), 0);    // just out of reach
}

}  // namespace
}  // namespace tiprub::simulate
