// SPDX-License-Identifier: GPL-3.0-or-later
// The rotor itself: static instability; rounding over long runs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simulate/motion/attempt.h"
#include "simulate/orbits/energy_audit.h"
#include "tests/stability/bench_scene.h"

namespace tiprub::simulate {
namespace {

/// K = k - Omega^2 m/4: it vanishes at Omega = 2 sqrt(k/m).
TEST(StaticLimit, IsTheSpeedAtWhichSofteningBeatsStiffness) {
  const double mass = 0.02, stiffness = 8e4, critical = 2 * std::sqrt(stiffness / mass);
  ReducedModel model = testing::one_mass(mass, stiffness);
  model.nodal_diameters[0].K[1] = -0.25 * model.nodal_diameters[0].M;
  EXPECT_NO_THROW(rotor_at_speed(model, 0.999 * critical, {0}, {0.01}));
  EXPECT_THROW(rotor_at_speed(model, 1.001 * critical, {0}, {0.01}), NoMotion);
  const testing::OwnedScene scene = testing::owned_scene(model, testing::lobed_casing(1, 1e-4, 5e-5), 600);
  EXPECT_EQ(simulate_speed(scene.view(), 0.99 * critical).response.failure, "");
  const std::string reason = simulate_speed(scene.view(), 1.01 * critical).response.failure;
  EXPECT_NE(reason.find("statically unstable"), std::string::npos) << reason;
}

/// The two-step recurrence in another precision, undamped, from rest at unit deflection.
template <class Number>
double drift(double angle, int steps) {
  const auto a = static_cast<Number>(2 * std::cos(angle));
  Number before = 1, now = static_cast<Number>(std::cos(angle));
  double worst = 0;
  for (int i = 2; i <= steps; ++i) {
    const Number next = a * now - before;
    before = now;
    now = next;
    worst = std::max(worst, std::abs(static_cast<double>(now) - std::cos(i * angle)));
  }
  return worst;
}

TEST(LongRunLimit, IsFarInDoubleAndNearInSingle) {
  constexpr int steps = 3'000'000;
  EXPECT_LT(drift<double>(0.0157, steps), 1e-6);
  EXPECT_GT(drift<float>(0.0157, steps), 0.1);
}

/// The same through the march: its energy after three million undamped steps.
TEST(LongRunLimit, KeepsTheEnergyOfTheMarch) {
  testing::Bench bench = testing::make_bench(testing::one_mass(0.02, 8e4), testing::round_wall(10), 2000, 0.0,
                                             {Scheme::trigonometric, ContactRule::complementarity, 400, 1});
  bench.march.set_state(0, Eigen::VectorXcd::Constant(3, 1e-4), Eigen::VectorXcd::Zero(3));
  bench.march.step();
  const EnergyAudit audit(bench.march);
  const double start = audit.energy(bench.march);
  for (int i = 0; i < 3'000'000; ++i) bench.march.step();
  EXPECT_LT(std::abs(audit.energy(bench.march) / start - 1), 1e-9);
}

}  // namespace
}  // namespace tiprub::simulate
