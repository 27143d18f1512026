// SPDX-License-Identifier: GPL-3.0-or-later
// The length of the step: central differences, penalty, the trigonometric scheme, Moreau-Jean.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simulate/march/rotor_at_speed.h"
#include "simulate/orbits/energy_audit.h"
#include "tests/stability/bench_scene.h"

namespace tiprub::simulate::step_limits_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double mass = 0.02, stiffness = 8e4, omega = 2000;  // omega^2 = stiffness/mass
constexpr int steps = 1000;

/// The speed at which h omega_max / 2 has a wanted value with `steps` a revolution.
double speed_for(double ratio, double omega_max) {
  return pi * omega_max / (ratio * steps);
}

/// Largest displacement over some revolutions, from a start on the highest modes; stops at 1 m.
double largest_motion(testing::Bench& bench, int revolutions) {
  const Eigen::Index modes = bench.rotor.waves[0].omega.size();
  const Eigen::VectorXcd start = Eigen::VectorXcd::Constant(modes, 1e-6);
  bench.march.set_state(0, start, start);
  double largest = 0;
  for (int i = 0; i < revolutions * steps && largest < 1; ++i) {
    bench.march.step();
    largest = std::max(largest, bench.march.displacement().cwiseAbs().maxCoeff());
  }
  return largest;
}

TEST(CentralDifferencesLimit, HoldsBelowAndIsGoneAbove) {
  const auto motion = [](double ratio) {
    testing::Bench bench =
        testing::make_bench(testing::one_mass(mass, stiffness), testing::round_wall(10), speed_for(ratio, omega), 0.0,
                            {Scheme::central_differences, ContactRule::complementarity, steps, 1});
    return largest_motion(bench, 4);
  };
  EXPECT_LT(motion(0.997), 1e-2);
  EXPECT_GE(motion(1.003), 1.0);
}

TEST(CentralDifferencesLimit, IsRefusedWithTheStepThatWouldDo) {
  for (double ratio : {0.99, 1.01}) {
    SimulateParameters parameters;
    parameters.scheme = Scheme::central_differences;
    const testing::OwnedScene scene = testing::owned_scene(testing::one_mass(mass, stiffness),
                                                           testing::lobed_casing(1, 1e-4, 5e-5), 1020, parameters);
    const double speed = pi * omega / (ratio * 1020);
    const SpeedResponse at = simulate_speed(scene.view(), speed).response;
    if (ratio < 1) {
      EXPECT_EQ(at.failure, "");
      EXPECT_NEAR(at.step_ratio, ratio, 1e-9);
    } else {
      EXPECT_NE(at.failure.find("and have 1.01 with 1020 steps"), std::string::npos) << at.failure;
      EXPECT_NE(at.failure.find("set [simulate] steps_per_revolution to at least 1031"), std::string::npos)
          << at.failure;
    }
  }
}

/// The tip rests on the penalty's spring, disturbed by a thousandth of what it penetrates: the largest disturbance
/// after 100 steps, in penetrations. kappa counts in omega_max.
double disturbance(double multiple, double ratio) {
  const double kappa = multiple * stiffness, sprung = std::sqrt((stiffness + kappa) / mass), overlap = 1e-4;
  testing::Bench bench =
      testing::make_bench(testing::one_mass(mass, stiffness), testing::round_wall(-overlap), speed_for(ratio, sprung),
                          0.0, {Scheme::penalty, ContactRule::complementarity, steps, 1, 0.5, kappa});
  EXPECT_NEAR(penalised_omega_max(bench.rotor, kappa) / sprung, 1, 1e-12);
  const double rest = -overlap * kappa / (stiffness + kappa), penetration = overlap + rest;
  const Eigen::MatrixXcd& Y = bench.rotor.waves[0].normal_rows;
  const Eigen::VectorXcd unit = Y.adjoint() / Y.squaredNorm();
  bench.march.set_state(0, unit * (rest + 1e-3 * penetration), unit * (1e-3 * penetration));
  double largest = 0;
  for (int i = 0; i < 100; ++i) {
    bench.march.step();
    largest = std::max(largest, std::abs(bench.march.displacement()[0] - rest) / penetration);
  }
  return largest;
}

TEST(PenaltyLimit, IsThatOfTheSprungWheel) {
  for (double multiple : {10.0, 1000.0}) {
    EXPECT_LT(disturbance(multiple, 0.99), 0.1) << multiple;
    EXPECT_GT(disturbance(multiple, 1.01), 1.0) << multiple;  // it leaves the wall
  }
}

TEST(PenaltyLimit, IsRefusedWithItsNumbersAndReportsPenetration) {
  const auto response = [](double multiple) {
    SimulateParameters parameters;
    parameters.scheme = Scheme::penalty;
    parameters.penalty_stiffness = multiple;
    const testing::OwnedScene scene = testing::owned_scene(testing::one_mass(mass, stiffness),
                                                           testing::lobed_casing(1, 1e-4, 5e-5), 10200, parameters);
    return simulate_speed(scene.view(), 200).response;
  };
  // h omega_max / 2 = pi / 1020 sqrt(1 + kappa): 1 at kappa = 105,300
  const SpeedResponse inside = response(1000), outside = response(110000);
  EXPECT_EQ(inside.failure, "");
  EXPECT_GT(inside.largest_penetration, 1e-9);
  EXPECT_GT(inside.leftover_steps, 0);
  EXPECT_NE(outside.failure.find("the springs of the penalty need"), std::string::npos) << outside.failure;
}

/// No limit: forty times beyond that of central differences the energy on a wall at rest never grows.
TEST(TrigonometricLimit, IsNone) {
  for (double ratio : {0.5, 1.01, 3.3, 40.0}) {
    testing::Bench bench =
        testing::make_bench(testing::one_mass(mass, stiffness), testing::round_wall(2e-5), speed_for(ratio, omega),
                            0.0, {Scheme::trigonometric, ContactRule::complementarity, steps, 1});
    bench.march.set_state(0, Eigen::VectorXcd::Zero(3), Eigen::VectorXcd::Constant(3, 1e-4));  // towards the wall
    bench.march.step();
    const EnergyAudit audit(bench.march);
    double last = audit.energy(bench.march);
    const double start = last;
    for (int i = 0; i < 20 * steps; ++i) {
      bench.march.step();
      const double energy = audit.energy(bench.march);
      ASSERT_LE(energy, last + 1e-13 * start) << ratio;
      last = energy;
    }
  }
}

/// What large steps cost is accuracy, and halving the step shows it.
TEST(TrigonometricLimit, ShowsItsErrorWhenTheStepIsHalved) {
  double last = HUGE_VAL;
  for (int resolution : {60, 240, 960}) {
    testing::OwnedScene scene =
        testing::owned_scene(testing::one_mass(mass, stiffness), testing::lobed_casing(1, 1e-3, 4e-4), resolution);
    scene.parameters.damping = {0.05};
    const SpeedResponse at = simulate_speed(scene.view(), 700, Depth::examined).response;
    ASSERT_EQ(at.failure, "");
    ASSERT_TRUE(at.audit.halving_difference.has_value());
    EXPECT_LT(*at.audit.halving_difference, 0.5 * last);
    last = *at.audit.halving_difference;
  }
  EXPECT_LT(last, 5e-3);
}

/// Logarithmic decrement of free decay, as a damping ratio: theta = 1/2 keeps what is there, more adds about
/// (theta - 1/2) omega h.
TEST(MoreauJeanLimit, DampsFreeMotionBeyondOneHalf) {
  constexpr double ratio = 0.01, speed = 20;  // omega h = 0.63
  const auto decrement = [&](double theta) {
    testing::Bench bench =
        testing::make_bench(testing::one_mass(mass, stiffness), testing::round_wall(10), speed, ratio,
                            {Scheme::moreau_jean, ContactRule::complementarity, steps, 1, theta});
    bench.march.set_state(0, Eigen::VectorXcd::Constant(3, 1e-3), Eigen::VectorXcd::Zero(3));
    bench.march.step();
    const EnergyAudit audit(bench.march);
    const double first = audit.energy(bench.march);
    constexpr int count = 500;
    for (int i = 0; i < count; ++i) bench.march.step();
    return 0.5 * std::log(first / audit.energy(bench.march)) / (count * omega * bench.march.time_step());
  };
  const double angle = omega * 2 * pi / speed / steps;
  EXPECT_NEAR(decrement(0.5), ratio, 0.1 * ratio);
  EXPECT_NEAR(decrement(0.52) - ratio, 0.02 * angle, 0.3 * 0.02 * angle);
}

}  // namespace
}  // namespace tiprub::simulate::step_limits_test
