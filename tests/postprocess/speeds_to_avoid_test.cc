// SPDX-License-Identifier: GPL-3.0-or-later
// Bands of speeds at which a wheel should not run.
#include "postprocess/records/speeds_to_avoid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "postprocess/records/error_budget_record.h"
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

  Study study;
  FieldResults fields;
};

/// A resonance with twice the allowed stress must fall to half of its height, and to a quarter for half the limit.
TEST_F(SpeedsToAvoid, ReachToWhereTheAmplitudeHasFallen) {
  const std::size_t worst = *worst_critical(study.critical);
  const CriticalSpeed& peak = study.critical[worst];
  EXPECT_TRUE(speeds_to_avoid(study, fields).empty());
  EXPECT_EQ(bands_in_words({}, fields).find("No speed"), 0U);
  set_goodman(worst, 2);
  const auto bands = speeds_to_avoid(study, fields);
  ASSERT_EQ(bands.size(), 1U);  // where the amplitude is above half of the limit, it may be above the limit as well
  EXPECT_EQ(bands[0].concern, Concern::above_limit);
  EXPECT_EQ(bands[0].widening, 0);
  for (const auto& [range, least] : {std::pair(bands[0].computed, 0.5), std::pair(bands[0].speeds, 0.25)}) {
    EXPECT_LE(range.low, peak.speed_low);
    EXPECT_GE(range.high, peak.speed_high);
    for (Eigen::Index k = 0; k < study.amplitudes.largest.size(); ++k) {
      const double speed = study.speed_at(k).speed;
      if (speed > range.low && speed < range.high && (speed < peak.speed_low || speed > peak.speed_high)) {
        EXPECT_GT(study.amplitudes.largest[k], least * peak.amplitude);
      }
    }
  }
  EXPECT_NE(bands_in_words(bands, fields).find("(Goodman above 1"), std::string::npos);
}

/// Symptom: a band ended where the amplitude of the computed peak had fallen, although friction moves that peak by
/// more than the band was wide; bands lay over each other, and their list began with the gravest.
TEST_F(SpeedsToAvoid, AreWidenedByTheErrorBudgetAndJoined) {
  constexpr double shift = -0.12;
  fields.varied.resize(study.critical.size());
  const std::size_t worst = *worst_critical(study.critical);
  for (std::size_t i = 0; i < study.critical.size(); ++i) set_goodman(i, i == worst ? 1.2 : 0.7);
  const auto before = speeds_to_avoid(study, fields);
  ASSERT_EQ(before.size(), 3U);
  const CriticalSpeed& peak = study.critical[worst];
  SpeedResponse& response = study.response.speeds[static_cast<std::size_t>(peak.index)];
  PeakVariation friction;
  friction.speed = (1 + shift) * peak.speed;
  friction.amplitude = friction.excursion = peak.amplitude;
  response.budget.push_back(friction);
  const auto bands = speeds_to_avoid(study, fields);
  const auto around = [&](const std::vector<AvoidedBand>& all) {
    return *std::ranges::find_if(all, [&](const AvoidedBand& band) {
      return band.speeds.low <= peak.speed && peak.speed <= band.speeds.high;
    });
  };
  const AvoidedBand narrow = around(before), wide = around(bands);
  const double open = sum_of(error_budgets(study, fields).front()).shift;
  EXPECT_GE(open, -shift);
  EXPECT_EQ(wide.widening, open);
  EXPECT_EQ(wide.speeds.low, (1 - open) * narrow.speeds.low);
  EXPECT_GE(wide.speeds.high, (1 + open) * narrow.speeds.high);
  EXPECT_EQ(wide.concern, Concern::above_limit);
  EXPECT_EQ(wide.computed.low, narrow.computed.low);
  EXPECT_EQ(wide.computed.high, narrow.computed.high);
  for (const auto& all : {before, bands})
    for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LT(all[i - 1].speeds.high, all[i].speeds.low);
  EXPECT_EQ(bands.size(), 2U);  // the widened one reaches the next
  EXPECT_NE(bands_in_words(bands, fields).find(" % at each end by the error budget)"), std::string::npos);
  EXPECT_EQ(reason_of({{1000, 2000}, Concern::above_limit, {1200, 1800}, 0.034}),
            "Goodman above 1 from 11459 to 17189 rpm, with 3.4 % at each end by the error budget");
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

}  // namespace
}  // namespace tiprub::postprocess
