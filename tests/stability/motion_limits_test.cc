// SPDX-License-Identifier: GPL-3.0-or-later
// What the motion does: slow settling, coexisting motions, broken symmetry.
#include <gtest/gtest.h>

#include <cmath>

#include "simulate/orbits/excluded_growth.h"
#include "simulate/orbits/settling.h"
#include "tests/stability/bench_scene.h"

namespace tiprub::simulate {
namespace {

/// A change far below the tolerance, which decays just fast enough, or grows.
bool judge(double rate) {
  SteadyState state(1e-3, 0.0);
  SettlingState found;
  for (int r = 0; r < 60; ++r) {
    Eigen::VectorXd motion = Eigen::VectorXd::LinSpaced(50, -1, 1);
    motion[3] += 1e-4 * std::pow(rate, r);
    state.add(motion);
    found = state.judge();
  }
  EXPECT_LT(found.change, 1e-3);  // one threshold alone would call both settled
  return found.settled();
}

TEST(SettlingLimit, IsTheDecayNotTheChange) {
  EXPECT_TRUE(judge(0.97));
  EXPECT_FALSE(judge(1.03));
}

/// A mass that the casing's crest comes near, but doesn't reach: at rest it stays at rest. Above its frequency (1000
/// rad/s) a larger motion meets the crest once a revolution, and that keeps it going; the fold is between 1000 and
/// 1050 rad/s. Symptom once: a difference to the motion from rest was taken relative to that, and was 0 if it rests.
class CoexistingMotions : public ::testing::Test {
 protected:
  SpeedResult settle(double speed, const RotorState& start) const {
    return simulate_speed(scene_.view(), speed, Depth::full, start);
  }
  static testing::OwnedScene make_scene() {
    testing::OwnedScene scene =
        testing::owned_scene(testing::one_mass(1.0, 1e6), testing::lobed_casing(1, 0.9e-4, 1e-4), 600);
    scene.parameters.max_revolutions = 400;
    return scene;
  }
  static RotorState swung_out() {
    RotorState state;
    state.displacement = state.velocity = {Eigen::VectorXcd::Zero(3)};
    state.displacement[0][0] = -2e-4;
    return state;
  }

  testing::OwnedScene scene_ = make_scene();
};

TEST_F(CoexistingMotions, EachStartEndsOnItsOwn) {
  const SpeedResponse rest = settle(1100, {}).response;
  const SpeedResponse swung = settle(1100, swung_out()).response;
  EXPECT_EQ(rest.contact_steps, 0);
  EXPECT_EQ(rest.displacement.cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(swung.motion, MotionClass::periodic);
  EXPECT_GT(swung.contact_steps, 0);
  EXPECT_GT(swung.displacement.cwiseAbs().maxCoeff(), 1.3e-4);
  EXPECT_LT(swung.displacement.cwiseAbs().maxCoeff(), 2e-4);
  ASSERT_TRUE(swung.audit.rest_difference.has_value());
  EXPECT_NEAR(*swung.audit.rest_difference, 1.0, 1e-9);
}

TEST_F(CoexistingMotions, SweepsUpAndDownDifferBetweenTheirFolds) {
  RotorState down = settle(1200, swung_out()).end, up;
  for (const double speed : {1100.0, 1050.0}) {
    const SpeedResult at = settle(speed, down);
    EXPECT_GT(at.response.contact_steps, 0) << speed << " rad/s, downwards";
    EXPECT_GT(*at.response.audit.rest_difference, 0.5);
    down = at.end;
  }
  const SpeedResponse below = settle(950, down).response;
  EXPECT_EQ(below.contact_steps, 0) << "below the fold there is no other motion than rest";
  EXPECT_LT(below.displacement.cwiseAbs().maxCoeff(), 1e-6);
  for (const double speed : {950.0, 1050.0, 1100.0, 1200.0}) {
    const SpeedResult at = settle(speed, up);
    EXPECT_EQ(at.response.contact_steps, 0) << speed << " rad/s, upwards";
    up = at.end;
  }
}

/// A disturbance of the nodal diameters that symmetry leaves out, on a wheel that rubs all around: damping takes it
/// away at the rate of its free decay or faster; negative damping, put there by hand, lets it grow.
Growth growth(double excluded_damping,
              const MarchSetup& setup = {Scheme::trigonometric, ContactRule::complementarity, 1200, 2}) {
  const ReducedModel model = testing::synthetic_wheel({});
  const Casing casing = testing::lobed_casing(2, 2e-4, 1.5e-4);
  RotorAtSpeed rotor = rotor_at_speed(model, 900, {0, 2}, {0.01});
  for (WaveModes& wave : rotor.others) wave.damping_ratio.setConstant(excluded_damping);
  TimeMarch march = testing::march_of(rotor, casing, model.contact, casing.given_clearance(model.contact), setup);
  for (int i = 0; i < 30 * setup.steps_per_revolution; ++i) march.step();
  return excluded_growth(march, 1, 24);
}

TEST(SymmetryLimit, IsTheGrowthOfWhatWasLeftOut) {
  EXPECT_EQ(judge(growth(0.01)), SymmetryVerdict::holds);
  EXPECT_EQ(judge(growth(-0.05)), SymmetryVerdict::breaking);
}

/// Symptom once: a growth of 1.7e5 a revolution, of a disturbance that never exceeds a percent of the motion. It is
/// the noise of contacts that open and close within a step.
TEST(SymmetryLimit, IsNotTheNoiseOfMoreauJean) {
  const MarchSetup setup{Scheme::moreau_jean, ContactRule::complementarity, 12000, 2};
  EXPECT_EQ(judge(growth(0.01, setup)), SymmetryVerdict::holds);
  EXPECT_EQ(judge(growth(-0.05, setup)), SymmetryVerdict::breaking);
}

}  // namespace
}  // namespace tiprub::simulate
