// SPDX-License-Identifier: GPL-3.0-or-later
// Bands of speeds at which a wheel should not run.
#include "postprocess/records/speeds_to_avoid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "postprocess/records/error_budget_record.h"
#include "postprocess/report/margin.h"
#include "postprocess/tables/table.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess {
namespace {

class SpeedsToAvoid : public ::testing::Test {
 protected:
  SpeedsToAvoid() : study(make_study({}, synthetic::model(), synthetic::resonant_sweep(synthetic::model()), {})) {
    for (SpeedResponse& speed : study.response.speeds) speed.clearance.setConstant(1);
    fields.peaks.resize(study.critical.size());
  }

  void set_goodman(std::size_t critical, double utilisation) {
    FieldPeak peak;
    peak.cycle = StressCycle{};
    peak.cycle->goodman = utilisation;
    fields.peaks[critical] = peak;
  }

  void add_failed(double rpm) {
    SpeedResponse speed;
    speed.speed = rpm * rad_s_per_rpm;
    study.failed.push_back(speed);
  }

  Study study;
  FieldResults fields;
};

/// The band round a speed.
AvoidedBand band_at(const std::vector<AvoidedBand>& all, double speed) {
  return *std::ranges::find_if(
      all, [&](const AvoidedBand& band) { return band.speeds.low <= speed && speed <= band.speeds.high; });
}

void expect_ascending(const std::vector<AvoidedBand>& all) {
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LE(all[i - 1].speeds.high, all[i].speeds.low);
}

/// A resonance with twice the allowed stress must fall to half of its height, and to a quarter for half the limit.
TEST_F(SpeedsToAvoid, ReachToWhereTheAmplitudeHasFallen) {
  const std::size_t worst = *worst_critical(study.critical);
  const CriticalSpeed& peak = study.critical[worst];
  EXPECT_TRUE(speeds_to_avoid(study, fields).empty());
  EXPECT_EQ(bands_in_words({}, fields).find("No speed"), 0U);
  set_goodman(worst, 2);
  const auto bands = speeds_to_avoid(study, fields);
  ASSERT_EQ(bands.size(), 3U);
  expect_ascending(bands);
  EXPECT_EQ(bands[1].concern, Concern::above_limit);
  for (const std::size_t side : {0, 2}) EXPECT_EQ(bands[side].concern, Concern::above_half);
  EXPECT_EQ(bands[1].widening, 0);
  const SpeedRange whole{bands[0].speeds.low, bands[2].speeds.high};
  for (const auto& [range, least] : {std::pair(bands[1].speeds, 0.5), std::pair(whole, 0.25)}) {
    EXPECT_LE(range.low, peak.speed_low);
    EXPECT_GE(range.high, peak.speed_high);
    for (Eigen::Index k = 0; k < study.amplitudes.largest.size(); ++k) {
      const double speed = study.speed_at(k).speed;
      if (speed > range.low && speed < range.high && (speed < peak.speed_low || speed > peak.speed_high)) {
        EXPECT_GT(study.amplitudes.largest[k], least * peak.amplitude);
      }
    }
  }
}

/// Symptom: a wheel in three lobes was to avoid 19,000 to 26,250 rpm for Goodman above 1, and at 21,000 rpm the
/// stress was 260 MPa of 445. Cause: another wave kept the amplitude above the share of the peak's that was looked
/// for.
TEST_F(SpeedsToAvoid, EndWhereTheStressHasFallenEvenIfTheAmplitudeHasNot) {
  const std::size_t worst = *worst_critical(study.critical);
  const Eigen::Index place = study.critical[worst].index;
  set_goodman(worst, 2);
  study.amplitudes.largest.setConstant(study.amplitudes.largest[place]);
  EXPECT_EQ(band_at(speeds_to_avoid(study, fields), study.critical[worst].speed).speeds.low, study.speed_at(0).speed);
  fields.over_speed = Eigen::VectorXd::Constant(study.amplitudes.largest.size(), 10);
  fields.over_speed[place] = 100;
  const auto bands = speeds_to_avoid(study, fields);
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_EQ(bands[0].concern, Concern::above_limit);
  EXPECT_EQ(bands[0].speeds.low, std::min(study.speed_at(place - 1).speed, study.critical[worst].speed_low));
  EXPECT_EQ(bands[0].speeds.high, std::max(study.speed_at(place + 1).speed, study.critical[worst].speed_high));
}

/// Symptom: a band ended where the amplitude of the computed peak had fallen, although friction moves that peak by
/// more than the band was wide; bands lay over each other, and their list began with the gravest.
TEST_F(SpeedsToAvoid, AreWidenedByTheErrorBudget) {
  constexpr double shift = -0.12;
  fields.varied.resize(study.critical.size());
  const std::size_t worst = *worst_critical(study.critical);
  for (std::size_t i = 0; i < study.critical.size(); ++i) set_goodman(i, i == worst ? 1.2 : 0.7);
  const auto before = speeds_to_avoid(study, fields);
  const CriticalSpeed& peak = study.critical[worst];
  SpeedResponse& response = study.response.speeds[static_cast<std::size_t>(peak.index)];
  PeakVariation friction;
  friction.speed = (1 + shift) * peak.speed;
  friction.amplitude = friction.excursion = peak.amplitude;
  response.budget.push_back(friction);
  const auto bands = speeds_to_avoid(study, fields);
  const AvoidedBand narrow = band_at(before, peak.speed), wide = band_at(bands, peak.speed);
  const double open = sum_of(error_budgets(study, fields).front()).shift;
  EXPECT_GE(open, -shift);
  EXPECT_EQ(wide.widening, open);
  EXPECT_EQ(wide.speeds.low, (1 - open) * narrow.speeds.low);
  EXPECT_EQ(wide.speeds.high, (1 + open) * narrow.speeds.high);
  EXPECT_EQ(wide.concern, Concern::above_limit);
  expect_ascending(before);
  expect_ascending(bands);
}

/// Symptom: friction made four of the five peaks of a wheel two to five times as high, and the page that said so
/// elsewhere told its reader to avoid one of them. What lowers the stress does not count.
TEST_F(SpeedsToAvoid, NameWhatTheErrorBudgetBringsAboveTheLimit) {
  fields.varied.resize(study.critical.size());
  const std::size_t worst = *worst_critical(study.critical);
  const CriticalSpeed& peak = study.critical[worst];
  set_goodman(worst, 0.4);
  fields.peaks[worst]->body.vibration = 1e8;
  PeakVariation friction;
  friction.speed = peak.speed;
  friction.amplitude = friction.excursion = peak.amplitude;
  study.response.speeds[static_cast<std::size_t>(peak.index)].budget.push_back(friction);
  for (const double factor : {0.1, 2.4}) {
    fields.varied[worst] = {factor * fields.peaks[worst]->body.vibration};
    EXPECT_TRUE(speeds_to_avoid(study, fields).empty());
  }
  fields.varied[worst] = {2.6 * fields.peaks[worst]->body.vibration};
  const auto bands = speeds_to_avoid(study, fields);
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_EQ(bands[0].concern, Concern::perhaps_above_limit);
  EXPECT_EQ(bands[0].speeds.low, (1 - bands[0].widening) * peak.speed_low);
  EXPECT_EQ(bands[0].speeds.high, (1 + bands[0].widening) * peak.speed_high);
  EXPECT_NE(bands_in_words(bands, fields).find("(Goodman perhaps above 1; "), std::string::npos);
  set_goodman(worst, 1.1);
  EXPECT_EQ(band_at(speeds_to_avoid(study, fields), peak.speed).concern, Concern::above_limit);
}

TEST_F(SpeedsToAvoid, AreToldWithTheirGrades) {
  const std::vector<AvoidedBand> bands = {{{1000, 1100}, Concern::above_half, 0},
                                          {{1500, 1600}, Concern::above_half, 0.01},
                                          {{1600, 1700}, Concern::above_limit, 0.034},
                                          {{1700, 1800}, Concern::above_half, 0.01}};
  set_goodman(0, 2);
  EXPECT_EQ(bands_in_words(bands, fields),
            "9549 to 10504 rpm (Goodman above 0.5; not widened without an error budget); 14324 to 17189 rpm (Goodman "
            "above 0.5 from 14324 to 15279 rpm and from 16234 to 17189 rpm; Goodman above 1 from 15279 to 16234 rpm; "
            "3.4 % at each end by the error budget).");
  EXPECT_EQ(reason_of(bands[2]), "Goodman above 1, 3.4 % at each end by the error budget");
}

/// One speed beyond its clearance: from the speed before it to the one after.
TEST_F(SpeedsToAvoid, WhereATipMovesBeyondTheClearance) {
  study.response.speeds[10].clearance.setConstant(1e-9);
  const auto bands = speeds_to_avoid(study, fields);
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_EQ(bands[0].concern, Concern::beyond_clearance);
  EXPECT_EQ(bands[0].speeds.low, study.response.speeds[9].speed);
  EXPECT_EQ(bands[0].speeds.high, study.response.speeds[11].speed);
}

/// The node with the least clearance need not be the one that moves most, and it moves towards the casing whatever
/// component the report shows.
TEST_F(SpeedsToAvoid, WhereAnyNodeMovesBeyondItsClearance) {
  const Eigen::Index most = study.amplitudes.node[10], other = most == 0 ? 1 : 0;
  ASSERT_GT(study.amplitudes.by_node(other, 10), 1e-9);
  study.response.speeds[10].clearance[other] = 1e-9;
  EXPECT_EQ(speeds_to_avoid(study, fields).size(), 1U);
  study.amplitudes.by_node.setZero();
  study.amplitudes.largest.setZero();
  EXPECT_EQ(speeds_to_avoid(study, fields).size(), 1U);
}

/// Symptom: a stress at one instant counted as none, so that the speed seemed safe, and strengths that were given
/// were asked for.
TEST_F(SpeedsToAvoid, NamesThePeaksThatAreNotRated) {
  const std::size_t worst = *worst_critical(study.critical), other = worst == 0 ? 1 : 0;
  FieldPeak instant;
  instant.speed = 20000 * rad_s_per_rpm;
  fields.peaks[other] = instant;
  EXPECT_NE(bands_in_words({}, fields).find("not known without whole cycles"), std::string::npos);
  set_goodman(worst, 0.1);
  EXPECT_NE(bands_in_words({}, fields)
                .find("not rated, because the response holds a single instant of the motion: 20000 rpm."),
            std::string::npos);
}

TEST_F(SpeedsToAvoid, NamesWhatIsUnknown) {
  study.failed.clear();
  EXPECT_EQ(unknown_speeds(study), "");
  for (const double rpm : {27000, 30000}) add_failed(rpm);
  for (const std::size_t i : {1, 2, 4}) study.response.speeds[i].audit.symmetry = SymmetryVerdict::breaking;
  OtherStart whole;
  whole.start = Start::whole_wheel;
  whole.blades = BladeExcursions{};
  study.response.speeds[2].other_starts = {whole};
  const auto rpm = [&](std::size_t i) { return fixed(study.response.speeds[i].speed * rpm_per_rad_s, 0); };
  EXPECT_EQ(
      unknown_speeds(study),
      " Not computed, because the march failed: 27000 and 30000 rpm. Blades may move farther where the symmetric "
      "motion is unstable: at " +
          rpm(1) + " and " + rpm(4) + " rpm.");
}

/// Symptom: "no critical speed inside", and a motion of 0.000 mm, of a range in which nothing had been simulated.
TEST_F(SpeedsToAvoid, TellTheOperatingRange) {
  const auto within = [&](double low, double high) {
    study.parameters.operating_min_rpm = low;
    study.parameters.operating_max_rpm = high;
    return margin_text(study, {{{14000 * rad_s_per_rpm, 15000 * rad_s_per_rpm}, Concern::above_limit}});
  };
  const std::string beyond = within(90000, 95000);
  EXPECT_TRUE(beyond.ends_with(" No speed inside it was simulated.")) << beyond;
  add_failed(14500);
  const std::string inside = within(14500, 16000);
  EXPECT_TRUE(inside.ends_with(" 1 speed inside it failed. Speeds to avoid reach into it: 14500 .. 15000 rpm."))
      << inside;
}

}  // namespace
}  // namespace tiprub::postprocess
