// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/sweep_tally.h"

#include <gtest/gtest.h>

#include <numbers>

namespace tiprub::simulate {
namespace {

SpeedResponse held(double rpm) {
  SpeedResponse at;
  at.speed = rpm * 2 * std::numbers::pi / 60;
  at.motion = MotionClass::periodic;
  return at;
}

TEST(SweepTally, SaysHowToRunTheSpeedsThatBreakTheSymmetry) {
  SweepTally tally;
  tally.add(held(9000));
  for (const double rpm : {12000.0, 13012.5}) {
    SpeedResponse at = held(rpm);
    at.audit.symmetry = SymmetryVerdict::breaking;
    tally.add(at);
  }
  EXPECT_EQ(tally.motions[MotionClass::periodic], 3u);
  EXPECT_NE(tally.warnings().find("symmetry-breaking at 2 speeds"), std::string::npos);
  EXPECT_NE(tally.warnings().find("nodal_diameters = \"all\""), std::string::npos);
  EXPECT_NE(tally.warnings().find("speeds_rpm = [12000, 13012.5]"), std::string::npos) << tally.warnings();
}

TEST(SweepTally, IsSilentWhereNothingIsWrong) {
  SweepTally tally;
  tally.add(held(9000));
  EXPECT_EQ(tally.warnings(), "");
  tally.cut_short = true;
  SimulateParameters parameters;
  parameters.speed_count_max = 48;
  EXPECT_NE(tally.warnings(parameters).find("speed_count_max = 48 ended the search"), std::string::npos);
  EXPECT_EQ(tally.text(), "1 periodic, 0 failed");
}

/// Symptom: a sweep in which nothing touched the casing ended like any other.
TEST(SweepTally, SaysThatNothingTouches) {
  ContactLine contact;
  contact.arc_length = Eigen::Vector3d(0, 1, 2);
  SweepTally tally;
  tally.crest = Eigen::Vector3d::Constant(2e-4);
  for (const double rpm : {9000.0, 12000.0}) {
    SpeedResponse at = held(rpm);
    at.clearance = Eigen::Vector3d(6e-4, 5e-4, 4e-4 - rpm * 1e-8);
    tally.add(at);
  }
  EXPECT_EQ(
      tally.untouched(contact),
      "\nno tip touches the casing at any speed: the gap closes to 8e-05 m at the least, at 12000 rev/min at the "
      "trailing edge; for contact, give [casing] less clearance or more distortion, in metres");
  SweepTally closed =
      tally;  // symptom: a speed at which the spin closes the clearance has failed, and counted for nothing
  closed.failed = 1;
  EXPECT_EQ(closed.untouched(contact), "");
  SpeedResponse touching = held(13000);
  touching.clearance = Eigen::Vector3d::Constant(2.1e-4);
  touching.contact_steps = 1;
  tally.add(touching);
  EXPECT_EQ(tally.untouched(contact), "");
}

/// Symptom: a crest of one degree stood between two steps of every revolution, and the motion was at rest.
TEST(SweepTally, SaysThatStepsPassTheCrestsBy) {
  SweepTally tally;
  tally.crest = Eigen::Vector3d::Constant(3e-4);
  SpeedResponse at = held(9000);
  at.clearance = Eigen::Vector3d(2e-4, 2e-4, 1e-4);
  tally.add(at);
  EXPECT_EQ(
      tally.untouched({}),
      "\nno step met the casing, although its crests overlap the tips by up to 0.0002 m: the crests are narrower "
      "than a step; give more steps_per_revolution");
}

TEST(SweepTally, CountsSpeedsWithoutAStableOrbit) {
  SpeedResponse at = held(9000);
  at.audit.orbit = {OrbitReport::Outcome::marched, 1, 25, 1e-2, 1.2};
  SweepTally tally;
  tally.add(at);
  EXPECT_NE(tally.text().find("marched, for want of a stable orbit, at 1"), std::string::npos);
  EXPECT_NE(speed_line(at).find("no orbit after 25 revolutions of maps, multiplier 1.2 a revolution"),
            std::string::npos);
}

/// Symptom: with central differences multipliers of 0 were printed for orbits whose return map has 0.44.
TEST(SweepTally, SaysWhereMultipliersLackTheInstantsOfImpacts) {
  SpeedResponse at = held(9000);
  at.audit.orbit = {OrbitReport::Outcome::found, 1, 25, 1e-6, 0.2};
  SweepTally tally;
  tally.add(at);  // without contact there is no impact
  at.contact_steps = 12;
  tally.add(at);
  EXPECT_EQ(tally.warnings(), "");
  SimulateParameters parameters;
  for (const Scheme scheme : {Scheme::central_differences, Scheme::residual_flexibility}) {
    parameters.scheme = scheme;
    EXPECT_EQ(tally.warnings(parameters),
              "\nat 1 speeds the Floquet multiplier lacks how the instants of impacts move: it does not hold where a "
              "node leaves at once; take scheme = \"trigonometric\"");
  }
}

/// Symptom once: a tolerance of 5e-4 gave a motion 2.3e-2 off where one of 5e-3 gave the right one, and one clause of
/// the summary said so.
TEST(SweepTally, SaysFirstThatTheStepsToleranceWasNotReached) {
  SpeedResponse at = held(9000);
  at.audit.step_reached = 0.9;
  SweepTally tally;
  tally.add(at);
  EXPECT_EQ(tally.text().find("step_tolerance"), std::string::npos) << tally.text();
  at.audit.step_reached = 46;
  tally.add(at);
  EXPECT_EQ(tally.text().find("step_tolerance not reached at 1 (by up to 46 times)"), 0) << tally.text();
  EXPECT_NE(speed_line(at).find("step_tolerance NOT REACHED: the estimated error is 46 times that"),
            std::string::npos);
}

}  // namespace
}  // namespace tiprub::simulate
