// SPDX-License-Identifier: GPL-3.0-or-later
// Bands of speeds at which a wheel should not run.
#include "postprocess/records/speeds_to_avoid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "postprocess/fields/field_study.h"
#include "postprocess/records/error_budget_record.h"
#include "postprocess/report/report.h"
#include "postprocess/tables/table.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess {
namespace {

class SpeedsToAvoid : public ::testing::Test {
 protected:
  SpeedsToAvoid() : study(make_study({}, synthetic::model(), synthetic::resonant_sweep(synthetic::model()), {})) {
    for (SpeedResponse& speed : study.response.speeds) speed.clearance.setConstant(1);
    fields.peaks.resize(study.critical.size());
    fields.utilisation = Eigen::VectorXd::Zero(study.amplitudes.largest.size());
  }

  /// Of a cycle without a mean stress.
  static FieldPeak rated(double utilisation) {
    FieldPeak peak;
    peak.cycle = StressCycle{};
    peak.cycle->alternating = utilisation;
    peak.cycle->goodman = utilisation;
    peak.cycle->strength = MaterialStrength{1, 1, {}};
    return peak;
  }
  void set_goodman(std::size_t critical, double utilisation) { fields.peaks[critical] = rated(utilisation); }
  /// The estimate is proportional to the amplitude, and that of a critical speed is given.
  void set_estimate(std::size_t critical, double utilisation) {
    fields.utilisation = utilisation / study.critical[critical].amplitude * study.amplitudes.largest;
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
TEST_F(SpeedsToAvoid, ReachToWhereTheStressHasFallen) {
  const std::size_t worst = *largest_critical(study.critical);
  const CriticalSpeed& peak = study.critical[worst];
  EXPECT_TRUE(speeds_to_avoid(study, fields).empty());
  EXPECT_EQ(bands_in_words({}, fields).find("No speed"), 0U);
  set_goodman(worst, 2);
  set_estimate(worst, 2);
  const auto bands = speeds_to_avoid(study, fields);
  expect_ascending(bands);
  EXPECT_LE(band_at(bands, peak.speed).speeds.low, peak.speed_low);
  EXPECT_GE(band_at(bands, peak.speed).speeds.high, peak.speed_high);
  const Eigen::VectorXd share = study.amplitudes.largest / peak.amplitude;
  for (Eigen::Index k = 1; k + 1 < share.size(); ++k) {
    const double speed = study.speed_at(k).speed;
    const auto inside = std::ranges::find_if(
        bands, [&](const AvoidedBand& band) { return band.speeds.low <= speed && speed <= band.speeds.high; });
    if (share.segment<3>(k - 1).maxCoeff() <= 0.25 && (speed < peak.speed_low || speed > peak.speed_high)) {
      EXPECT_EQ(inside, bands.end()) << share[k];
    }
    if (share[k] <= 0.25) continue;
    ASSERT_NE(inside, bands.end()) << share[k];
    EXPECT_EQ(inside->widening, 0);
    if (share[k] > 0.5) {
      EXPECT_EQ(inside->concern, Concern::above_limit);
    }
  }
}

/// Symptom: a wheel in three lobes was to avoid 19,000 to 26,250 rpm for Goodman above 1, and at 21,000 rpm the
/// stress was 260 MPa of 445. Cause: another wave kept the amplitude above the share of the peak's that was looked
/// for.
TEST_F(SpeedsToAvoid, EndWhereTheStressHasFallenEvenIfTheAmplitudeHasNot) {
  const std::size_t worst = *largest_critical(study.critical);
  const Eigen::Index place = study.critical[worst].index;
  set_goodman(worst, 2);
  study.amplitudes.largest.setConstant(study.amplitudes.largest[place]);
  fields.utilisation.setConstant(0.2);
  const auto bands = speeds_to_avoid(study, fields);
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_EQ(bands[0].concern, Concern::above_limit);
  EXPECT_EQ(bands[0].speeds.low, std::min(study.speed_at(place - 1).speed, study.critical[worst].speed_low));
  EXPECT_EQ(bands[0].speeds.high, std::max(study.speed_at(place + 1).speed, study.critical[worst].speed_high));
}

/// Symptom: speeds with a Goodman's utilisation of 1.57 were "outside the speeds to avoid", because the amplitude has
/// no critical speed there: at a small peak, or at the end of the range.
TEST_F(SpeedsToAvoid, IncludeStressedSpeedsThatAreNotCritical) {
  const std::size_t worst = *largest_critical(study.critical);
  const Eigen::Index place = study.critical[worst].index, last = fields.utilisation.size() - 1;
  fields.utilisation.setConstant(0.1);
  fields.utilisation[place] = 0.7;  // by the cycle it is 0.8
  fields.utilisation[last] = 1.6;
  set_goodman(worst, 0.8);
  const auto bands = speeds_to_avoid(study, fields);
  ASSERT_EQ(bands.size(), 2U);
  EXPECT_EQ(bands[1].concern, Concern::above_limit);
  EXPECT_EQ(bands[1].speeds.low, study.speed_at(last - 1).speed);
  EXPECT_EQ(bands[1].speeds.high, study.speed_at(last).speed);
  EXPECT_EQ(utilisation_over_speed(study, fields)[last], 1.6);
  EXPECT_EQ(utilisation_over_speed(study, fields)[place], 0.8);
}

/// Symptom: "No speed at which a tip moves beyond the clearance" stood below a utilisation of 2.02.
TEST_F(SpeedsToAvoid, IncludeTheOnlySpeedThereIs) {
  study.response.speeds.resize(1);
  study.critical.clear();
  fields.peaks.clear();
  study.amplitudes.largest.conservativeResize(1);
  fields.utilisation = Eigen::VectorXd::Constant(1, 2.02);
  const auto bands = speeds_to_avoid(study, fields);
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_EQ(bands[0].concern, Concern::above_limit);
}

TEST_F(SpeedsToAvoid, KnowTheStressWithoutACriticalSpeed) {
  study.critical.clear();
  fields.peaks.clear();
  EXPECT_TRUE(speeds_to_avoid(study, fields).empty());
  fields.of_no_critical = rated(1.2);
  const auto bands = speeds_to_avoid(study, fields);
  ASSERT_FALSE(bands.empty());
  EXPECT_EQ(band_at(bands, study.worst_response().speed).concern, Concern::above_limit);
}

/// Symptom: the worst critical speed was that of the largest amplitude, with a utilisation of 1.97, and another one
/// had 2.45.
TEST_F(SpeedsToAvoid, WorstIsThatOfTheLargestUtilisation) {
  const std::size_t largest = *largest_critical(study.critical), other = largest == 0 ? 1 : 0;
  EXPECT_EQ(worst_critical(study, fields), largest);
  fields.peaks[largest] = fields.peaks[other] = FieldPeak{};
  fields.peaks[other]->body.vibration = 1;
  EXPECT_EQ(worst_critical(study, fields), other) << "by stress";
  set_goodman(largest, 1.97);
  EXPECT_EQ(worst_critical(study, fields), largest);
  set_goodman(other, 2.45);
  EXPECT_EQ(worst_critical(study, fields), other);
  fields.utilisation[study.critical[largest].index] = 3;
  fields.peaks[largest]->cycle.reset();
  EXPECT_EQ(worst_critical(study, fields), largest) << "a single instant, estimated";
  set_goodman(largest, 1.97);
  EXPECT_NE(verdict(study, fields, {}).front().text.find("The worst, at " + rpm_text(study.critical[other].speed)),
            std::string::npos);
}

/// Symptom: a band ended where the amplitude of the computed peak had fallen, although friction moves that peak by
/// more than the band was wide; bands lay over each other, and their list began with the gravest.
TEST_F(SpeedsToAvoid, AreWidenedByTheErrorBudget) {
  constexpr double shift = -0.12;
  fields.varied.resize(study.critical.size());
  const std::size_t worst = *largest_critical(study.critical);
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
  const std::size_t worst = *largest_critical(study.critical);
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
  const std::size_t worst = *largest_critical(study.critical), other = worst == 0 ? 1 : 0;
  FieldPeak instant;
  instant.speed = 20000 * rad_s_per_rpm;
  fields.peaks[other] = instant;
  fields.utilisation.resize(0);
  EXPECT_NE(bands_in_words({}, fields).find("not known without endurance_limit"), std::string::npos);
  fields.utilisation = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(study.response.speeds.size()));
  EXPECT_NE(
      bands_in_words({}, fields).find("estimated, because the response holds no whole cycle of a critical speed"),
      std::string::npos);
  set_goodman(worst, 0.1);
  EXPECT_NE(bands_in_words({}, fields)
                .find("estimated, because the response holds a single instant of the motion: 20000 rpm."),
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

/// Symptom: a critical speed with a utilisation above 1 did not count, because it moves the tip by little.
TEST_F(SpeedsToAvoid, SmallMotionsCountForTheMarginIfTheyBreakTheWheel) {
  const CriticalSpeed& peak = study.critical.front();
  study.parameters.operating_min_rpm = 0.99 * peak.speed * rpm_per_rad_s;
  study.parameters.operating_max_rpm = 1.01 * peak.speed * rpm_per_rad_s;
  study.parameters.operating_amplitude_mm = 2 * peak.amplitude * mm_per_m;
  const auto counts = [&] {
    return margin_text(study, fields, {}).find("no critical speed inside") == std::string::npos;
  };
  EXPECT_FALSE(counts());
  set_goodman(0, 0.9);
  EXPECT_FALSE(counts());
  set_goodman(0, 1.1);
  EXPECT_TRUE(counts());
}

/// Symptom: "no critical speed inside", and a motion of 0.000 mm, of a range in which nothing had been simulated.
TEST_F(SpeedsToAvoid, TellTheOperatingRange) {
  const auto within = [&](double low, double high) {
    study.parameters.operating_min_rpm = low;
    study.parameters.operating_max_rpm = high;
    return margin_text(study, fields, {{{14000 * rad_s_per_rpm, 15000 * rad_s_per_rpm}, Concern::above_limit}});
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
