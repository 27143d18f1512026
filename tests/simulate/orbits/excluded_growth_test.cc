// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/excluded_growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::excluded_growth_test {
namespace {

constexpr double speed = 900;
constexpr int steps = 1200;

RotorAtSpeed two_lobed_rotor(const ReducedModel& model, double damping) {
  std::vector<int> moving;
  for (int n = 0; n <= model.nodal_diameter_max(); n += 2) moving.push_back(n);
  return rotor_at_speed(model, speed, moving, {damping});
}

/// Of what symmetry leaves out, against two lobes that the blades never reach: free modes.
Growth free_growth(const ReducedModel& model, const RotorAtSpeed& rotor, int period, int revolutions = 24) {
  const Casing casing = testing::lobed_casing(2, 1e-4, 1.0);
  TimeMarch march = testing::march_of(rotor, casing, model.contact, casing.given_clearance(model.contact),
                                      {Scheme::trigonometric, ContactRule::complementarity, steps, 2});
  for (std::size_t i = 0; i < march.wave_count(); ++i) {  // something to measure the seed by
    const Eigen::VectorXcd q = Eigen::VectorXcd::Constant(march.wave(i).moving, 1e-6);
    march.set_state(i, q, Eigen::VectorXcd::Zero(q.size()));
  }
  return excluded_growth(march, period, revolutions);
}

/// Symptom once: the growth of wheels whose disturbances all decay was fitted to rounding, and 12 of 40 were flagged.
TEST(ExcludedGrowth, IsTheSlowestDecayOfFreeModes) {
  for (int generalized = 2; generalized <= 9; ++generalized)
    for (const double damping : {0.003, 0.02, 0.3}) {
      const ReducedModel model = testing::synthetic_wheel({6, 3, generalized});
      const RotorAtSpeed rotor = two_lobed_rotor(model, damping);
      double slowest = 0;
      for (const WaveModes& wave : rotor.others)
        slowest = std::max(slowest, std::exp(-damping * wave.omega[0] * 2 * std::numbers::pi / speed));
      const Growth growth = free_growth(model, rotor, 1);
      EXPECT_NEAR(growth.factor, slowest, 5e-3 + 2 * growth.uncertainty) << generalized << ", damping " << damping;
      EXPECT_EQ(judge(growth), SymmetryVerdict::holds) << generalized << ", damping " << damping;
      EXPECT_LT(free_growth(model, rotor, 0).factor, 1);
    }
}

/// Symptom once: 0.957 was reported where a disturbance grows by 1.010 a revolution in the long run: what decays hid
/// it.
TEST(ExcludedGrowth, FindsASlowGrowthBehindDecays) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  RotorAtSpeed rotor = two_lobed_rotor(model, 0.005);
  double& damping = rotor.others.front().damping_ratio[3];
  damping = -std::log(1.01) * speed / (2 * std::numbers::pi) / rotor.others.front().omega[3];
  const Growth growth = free_growth(model, rotor, 1);
  EXPECT_NEAR(growth.factor, 1.01, 1e-3);
  EXPECT_EQ(judge(growth), SymmetryVerdict::breaking);
}

/// Symptom: with one revolution nothing was averaged, and tiprub-simulate died of a segmentation fault.
TEST(ExcludedGrowth, IsThatOfASingleRevolutionToo) {
  const ReducedModel model = testing::synthetic_wheel({6, 3, 6});
  const Growth growth = free_growth(model, two_lobed_rotor(model, 0.02), 0, 1);
  EXPECT_GT(growth.factor, 0);
  EXPECT_LT(growth.factor, 1);
}

TEST(ExcludedGrowth, IsUndecidedNearOne) {
  EXPECT_EQ(judge({1.0005, 0}), SymmetryVerdict::undecided);
  EXPECT_EQ(judge({0.98, 0.03}), SymmetryVerdict::undecided);
  EXPECT_EQ(judge({0.98, 0.01}), SymmetryVerdict::holds);
  EXPECT_EQ(judge({1.05, 0.01}), SymmetryVerdict::breaking);
}

/// Symptom: one of 88 verdicts was a wrong "holds", of a motion without period.
TEST(ExcludedGrowth, ProvesNoDecayAlongAMotionWithoutPeriod) {
  EXPECT_EQ(judge({0.98, 0.01}, 2), SymmetryVerdict::holds);
  EXPECT_EQ(judge({0.98, 0.01}, 0), SymmetryVerdict::undecided);
  EXPECT_EQ(judge({1.05, 0.01}, 0), SymmetryVerdict::breaking);
}

}  // namespace
}  // namespace tiprub::simulate::excluded_growth_test
