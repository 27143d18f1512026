// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/settling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tiprub::simulate::steady_state_test {
namespace {

constexpr double tolerance = 1e-3;
constexpr int samples = 50;

/// A revolution of base motion plus `amount` of another shape.
Eigen::VectorXd revolution(double amount) {
  Eigen::VectorXd motion(samples);
  for (int i = 0; i < samples; ++i) motion[i] = std::sin(0.3 * i) + amount * std::cos(1.1 * i);
  return motion;
}

/// The first revolution at which the motion counts as settled, or -1.
int settles_at(const std::function<double(int)>& amount, int revolutions, SettlingState& found) {
  SteadyState state(tolerance, 0.0);
  for (int r = 0; r < revolutions; ++r) {
    state.add(revolution(amount(r)));
    found = state.judge();
    if (found.settled()) return r;
  }
  return -1;
}

TEST(SteadyState, SettlesWhenWhatIsStillToComeIsSmall) {
  for (double rate : {0.3, 0.8, 0.95}) {
    SettlingState found;
    const int at = settles_at([&](int r) { return std::pow(rate, r); }, 500, found);
    ASSERT_GT(at, 0);
    EXPECT_EQ(found.period_revolutions, 1);
    EXPECT_NEAR(found.rate, rate, 0.01);
    EXPECT_LT(std::pow(rate, at), 1.2 * tolerance);  // its distance from the end
  }
}

TEST(SteadyState, IsNotTakenInByAChangeThatIsSmallAndSlow) {
  SettlingState found;  // the change is below the tolerance from the start, the way to go is not
  const int at = settles_at([](int r) { return 0.2 * std::pow(0.998, r); }, 200, found);
  EXPECT_EQ(at, -1);
  EXPECT_LT(found.change, tolerance);
}

TEST(SteadyState, IsNotTakenInByAChangeThatFellAndGrowsAgain) {
  SettlingState found;
  const auto valley = [](int r) { return 1e-2 * std::cosh((r - 15) / 4.0) / std::cosh(15 / 4.0); };
  SteadyState state(tolerance, 0.0);
  int small = 0;
  for (int r = 0; r < 40; ++r) {
    state.add(revolution(valley(r)));
    found = state.judge();
    if (r < 22) continue;  // on its way up
    small += found.change < tolerance ? 1 : 0;
    EXPECT_FALSE(found.settled()) << r;
  }
  EXPECT_GT(small, 0);
}

TEST(SteadyState, FindsThePeriodInRevolutions) {
  for (int order = 2; order <= SteadyState::longest_period; ++order) {
    SettlingState found;
    const int at = settles_at([&](int r) { return r % order == 0 ? 0.3 : 0.1; }, 60, found);
    EXPECT_GT(at, 0) << order;
    EXPECT_EQ(found.period_revolutions, order);
  }
}

/// A disturbance that alternates on its way to zero changes less over two revolutions than over one, and was once
/// taken for a subharmonic of order 2.
TEST(SteadyState, TakesAnAlternatingDecayForWhatItBecomes) {
  for (double rate : {0.5, 0.8, 0.9}) {
    SettlingState found;
    EXPECT_GT(settles_at([&](int r) { return std::pow(-rate, r); }, 500, found), 0);
    EXPECT_EQ(found.period_revolutions, 1) << rate;
  }
}

TEST(SteadyState, LeavesTheRestUnsettled) {
  SettlingState found;
  EXPECT_EQ(settles_at([](int r) { return 0.2 * std::sin(2.39996 * r); }, 100, found), -1);
  EXPECT_EQ(found.period_revolutions, 0);
}

/// Marching ends early only where the change neither falls, as towards a settled motion, nor grows, as away from an
/// orbit that repels.
TEST(SteadyState, TellsAChangeThatStandsFromOneThatMoves) {
  const auto stands = [](double rate) {
    SteadyState state(tolerance, 0.0);
    for (int r = 0; r < 70; ++r) {
      const double scatter = 1 + 0.3 * std::sin(2.39996 * r), sign = r % 2 == 0 ? 1 : -1;
      state.add(revolution(1e-3 * std::pow(rate, r - 35) * scatter * sign));
    }
    return state.stands(30);
  };
  EXPECT_TRUE(stands(1));
  for (const double rate : {0.9, 0.96, 1.04, 1.1}) EXPECT_FALSE(stands(rate)) << rate;
}

bool stands_after(const std::function<double(int)>& change) {
  SteadyState state(tolerance, 0.0);
  for (int r = 0; r < 70; ++r) state.add(revolution(1e-3 * change(r) * (r % 2 == 0 ? 1 : -1)));
  return state.stands(30);
}

/// Symptom: after a false orbit had been left, no change counted as one that stands, and the march ended.
TEST(SteadyState, StandsOnlyAfterSomeChanges) {
  SteadyState state(tolerance, 0.0);
  EXPECT_FALSE(state.stands(30));
  for (int r = 0; r < 7; ++r) state.add(revolution(r % 2));
  EXPECT_FALSE(state.stands(30));
  for (int r = 7; r < 20; ++r) state.add(revolution(r % 2));
  EXPECT_TRUE(state.stands(30));
}

/// A slow modulation grows for a while, with a slope that is far beyond its uncertainty. A fall that is as slow may
/// lead to a settled motion, as it does near folds.
TEST(SteadyState, TellsASlowModulationFromASlowFall) {
  EXPECT_TRUE(stands_after([](int r) { return 1 - 0.3 * std::cos(0.05 * r); }));
  EXPECT_FALSE(stands_after([](int r) { return std::pow(0.99, r); }));
}

TEST(SteadyState, TakesAMotionBelowTheQuietNormForNone) {
  SteadyState state(tolerance, 1.0);
  for (int r = 0; r < 12; ++r) state.add(1e-6 * revolution(std::sin(r)));
  EXPECT_TRUE(state.judge().settled());
}

}  // namespace
}  // namespace tiprub::simulate::steady_state_test
