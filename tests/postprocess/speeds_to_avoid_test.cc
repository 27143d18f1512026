// SPDX-License-Identifier: GPL-3.0-or-later
// Bands of speeds at which a wheel should not run.
#include "postprocess/records/speeds_to_avoid.h"

#include <gtest/gtest.h>

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
  ASSERT_EQ(bands.size(), 2U);
  EXPECT_EQ(bands[0].concern, Concern::above_limit);
  EXPECT_EQ(bands[1].concern, Concern::above_half);
  EXPECT_LE(bands[1].speeds.low, bands[0].speeds.low);
  EXPECT_GE(bands[1].speeds.high, bands[0].speeds.high);
  for (const AvoidedBand& band : bands) {
    EXPECT_LE(band.speeds.low, peak.speed_low);
    EXPECT_GE(band.speeds.high, peak.speed_high);
    const double least = (band.concern == Concern::above_limit ? 0.5 : 0.25) * peak.amplitude;
    for (Eigen::Index k = peak.index; study.speed_at(k).speed < peak.speed_high; ++k)
      EXPECT_GT(study.amplitudes.largest[k], least);
    for (Eigen::Index k = 0; k < study.amplitudes.largest.size(); ++k) {
      const bool inside = study.speed_at(k).speed > band.speeds.low && study.speed_at(k).speed < band.speeds.high;
      if (inside && (study.speed_at(k).speed < peak.speed_low || study.speed_at(k).speed > peak.speed_high)) {
        EXPECT_GT(study.amplitudes.largest[k], least);
      }
    }
  }
  EXPECT_NE(bands_in_words(bands, fields).find("(Goodman above 1); "), std::string::npos);
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
