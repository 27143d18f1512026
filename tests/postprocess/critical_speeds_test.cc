// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/critical_speeds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "postprocess/records/study_records.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess::critical_speeds_test {
namespace {

constexpr double rounding = 1e-13;

/// Five speeds, a peak at the third. Over the tip line EO 2 is the largest wave and rises most; at the trailing
/// edge, which moves most, EO 6 does.
Response peak_at_the_trailing_edge(const ReducedModel& rotor) {
  const Eigen::Vector4d all_but_last = {1, 1, 1, 0.2}, last = {0, 0, 0, 1};
  Response response{synthetic::two_lobes(), "made", {}, synthetic::frequencies(rotor)};
  for (const double speed : {1150.0, 1200.0, 1250.0, 1300.0, 1350.0}) {
    const bool peak = speed == 1250.0;
    std::vector<synthetic::Wave> waves = {{2, 2, peak ? 1e-4 : 1e-5, 0.3, all_but_last},
                                          {6, -4, peak ? 1.5e-4 : 2e-5, 0.1, last}};
    double beside = 4.5e-5;
    for (const int order : {8, 10, 12, 14, 16}) {
      waves.push_back({static_cast<double>(order), signed_nodal_diameter(order, 10), beside, 0.2, last});
      beside -= 3e-6;
    }
    response.speeds.push_back(synthetic::speed(response.scene, rotor.contact, speed, waves, 1));
  }
  return response;
}

std::vector<CriticalSpeed> peaks_of(const Response& response, const ReducedModel& rotor) {
  return critical_speeds(response, rotor.contact, tip_amplitudes(response, rotor.contact, Component::normal),
                         FrequencyCurves(response.frequencies), {});
}

/// Symptom: the table gave the trailing edge's 0.315 mm to EO 2, which has 0.029 mm there; EO 6 has 0.186 mm. Cause:
/// the amplitude was the worst node's, its wave that of a mean over the nodes. The label belongs to the amplitude.
TEST(CriticalSpeeds, AreNamedAtTheNodeThatMovesMost) {
  const ReducedModel rotor = synthetic::model();
  const Response response = peak_at_the_trailing_edge(rotor);
  const std::vector<CriticalSpeed> found = peaks_of(response, rotor);
  ASSERT_EQ(found.size(), 1U);
  const CriticalSpeed& critical = found.front();
  EXPECT_EQ(critical.node, 3);
  EXPECT_EQ(critical.rising.engine_order, 6);
  EXPECT_EQ(critical.rising.signed_nodal_diameter, -4);
  EXPECT_NEAR(critical.rising.amplitude, 1.5e-4, rounding);
  EXPECT_NEAR(critical.wave_share(), 1.5e-4 / critical.amplitude, rounding);
}

/// Beside it the other large ones, in their order; EO 2 has an eighth of it at that node, and is none.
TEST(CriticalSpeeds, TellTheOtherLargeWaves) {
  const ReducedModel rotor = synthetic::model();
  const Response response = peak_at_the_trailing_edge(rotor);
  const std::vector<CriticalSpeed> found = peaks_of(response, rotor);
  ASSERT_EQ(found.size(), 1U);
  const std::vector<WaveLabel>& others = found.front().others;
  ASSERT_EQ(others.size(), 4U);  // the fifth, EO 16, is one too many
  for (std::size_t i = 0; i < others.size(); ++i) {
    EXPECT_EQ(others[i].engine_order, 8 + 2 * static_cast<int>(i));
    EXPECT_NEAR(others[i].amplitude, 4.5e-5 - 3e-6 * static_cast<double>(i), rounding);
  }
}

/// Symptom: the table named EO 20, which makes the peak, and listed EO 8, which is larger, among the others.
TEST(CriticalSpeeds, NameALargerWaveThatRisesLess) {
  const ReducedModel rotor = synthetic::model();
  Response response = peak_at_the_trailing_edge(rotor);
  response.speeds.clear();
  for (const double speed : {1150.0, 1200.0, 1250.0, 1300.0, 1350.0}) {
    const bool peak = speed == 1250.0;
    response.speeds.push_back(
        synthetic::speed(response.scene, rotor.contact, speed,
                         {{6, -4, peak ? 1e-4 : 2e-5, 0.1}, {8, -2, peak ? 1.2e-4 : 0.9e-4, 0.3}}, 1));
  }
  const CriticalSpeed critical = peaks_of(response, rotor).front();
  EXPECT_EQ(critical.rising.engine_order, 6);
  EXPECT_EQ(critical.largest.engine_order, 8);
  EXPECT_TRUE(critical.has_larger_wave());
  EXPECT_EQ(wave_names(critical), "EO 8 ND -2");
  EXPECT_EQ(wave_name(critical.waves_beside().front()), "EO 6 ND -4");
  const CriticalSpeed usual = peaks_of(peak_at_the_trailing_edge(rotor), rotor).front();
  EXPECT_FALSE(usual.has_larger_wave());
  EXPECT_EQ(wave_names(usual), "EO 6 ND -4");
}

/// Symptom: a peak was named after a wave that held 28 % of it.
TEST(CriticalSpeeds, CallAMotionMixedThatNoWaveHoldsHalfOf) {
  CriticalSpeed critical;
  const auto wave = [](double engine_order, int nodal_diameter, double amplitude) {
    return WaveLabel{.engine_order = engine_order, .signed_nodal_diameter = nodal_diameter, .amplitude = amplitude};
  };
  critical.amplitude = 1e-4;
  critical.rising = critical.largest = wave(10, 0, 4.8e-5);
  critical.others = {wave(6, -4, 3e-5), wave(2, 2, 2.1e-5), wave(4, 4, 2e-5)};
  EXPECT_EQ(wave_names(critical), "mixed: EO 10 ND 0 48 %, EO 6 ND -4 30 %, EO 2 ND +2 21 %");
  critical.rising.amplitude = 5e-5;
  EXPECT_EQ(wave_names(critical), "EO 10 ND 0");
}

/// Symptom: where several waves meet, a peak was called "mixed: EO 15 ND +5 11 %, EO 6 ND -4 77 %".
TEST(CriticalSpeeds, NameAMotionAfterTheWaveThatHoldsMostOfIt) {
  CriticalSpeed critical;
  critical.amplitude = 1e-4;
  critical.rising = {.engine_order = 15, .signed_nodal_diameter = 5, .amplitude = 1.1e-5};
  critical.largest = {.engine_order = 6, .signed_nodal_diameter = -4, .amplitude = 7.7e-5};
  critical.others = {critical.largest, {.engine_order = 3, .signed_nodal_diameter = 3, .amplitude = 1.9e-5}};
  EXPECT_EQ(wave_names(critical), "EO 6 ND -4");
  ASSERT_EQ(critical.waves_beside().size(), 2U);
  EXPECT_EQ(wave_name(critical.waves_beside()[0]), "EO 3 ND +3");
  EXPECT_EQ(wave_name(critical.waves_beside()[1]), "EO 15 ND +5");
  critical.largest.amplitude = critical.others[0].amplitude = 4.8e-5;
  EXPECT_EQ(wave_names(critical), "mixed: EO 6 ND -4 48 %, EO 3 ND +3 19 %, EO 15 ND +5 11 %");
}

/// Symptom: the largest peaks were called periodic where blades that part from each other leave that motion.
TEST(MotionText, SaysWhatSymmetryHides) {
  SpeedResponse speed;
  speed.motion = MotionClass::periodic;
  speed.other_starts = {{Start::up, "", 1e-4, {}, MotionClass::periodic, 1, 0}};
  EXPECT_EQ(motion_text(speed), "periodic");
  EXPECT_EQ(whole_wheel_text(speed), "");
  speed.audit.symmetry = SymmetryVerdict::undecided;
  EXPECT_EQ(motion_text(speed), "symmetric, stability open (periodic)");
  speed.audit.symmetry = SymmetryVerdict::breaking;
  EXPECT_EQ(motion_text(speed), "symmetric, unstable (periodic)");
  speed.other_starts.push_back(
      {Start::whole_wheel, "", 2e-4, BladeExcursions{2.9e-3, 3.3e-3, 4.12e-3}, MotionClass::subharmonic, 5, 0});
  EXPECT_EQ(whole_wheel_text(speed), "subharmonic 1/5, |u| 2.90 / 3.30 / 4.12");
  speed.other_starts.back().failure = "too many steps";
  EXPECT_EQ(whole_wheel_text(speed), "");
}

/// Symptom: two stretches of one modulated motion, whose amplitudes differ by a tenth, were listed as two motions.
TEST(MotionText, StretchesOfOneIrregularMotionAreNotOtherMotions) {
  Study study = make_study({}, synthetic::model(), synthetic::resonant_sweep(synthetic::model()), {});
  FieldResults fields;
  fields.peaks.resize(study.critical.size());
  SpeedResponse& response = study.response.speeds[static_cast<std::size_t>(study.critical.front().index)];
  response.other_starts = {{Start::up, "", 0.9 * response.amplitude, {}, MotionClass::modulated, 0, 0.3}};
  const auto listed = [&] {
    const Table table = critical_speed_record(study, fields);
    const auto column = std::ranges::find(table.header, "motions from other starts") - table.header.begin();
    return std::get<std::string>(table.rows.front()[static_cast<std::size_t>(column)]);
  };
  response.motion = MotionClass::periodic;
  EXPECT_NE(listed().find("up: modulated"), std::string::npos);
  response.motion = MotionClass::modulated;
  EXPECT_EQ(listed(), "none found");
  response.other_starts.front().difference = 0.8;
  EXPECT_NE(listed().find("up: modulated"), std::string::npos);
}

std::vector<CriticalSpeed> peaks_at(const std::vector<std::pair<double, double>>& speeds_and_amplitudes) {
  std::vector<CriticalSpeed> critical;
  for (const auto& [speed, amplitude] : speeds_and_amplitudes) {
    critical.emplace_back();
    critical.back().speed = speed;
    critical.back().speed_low = speed - 5;
    critical.back().speed_high = speed + 10;
    critical.back().amplitude = amplitude;
  }
  return critical;
}

/// From the nearer end of the interval in which the critical speed lies.
TEST(OperatingMargin, IsToTheNearestCriticalSpeedOutside) {
  const auto critical = peaks_at({{800, 2e-4}, {890, 1e-4}, {990, 3e-4}, {1500, 1e-4}, {2205, 2e-4}, {2500, 2e-4}});
  const OperatingMargin margin = operating_margin(critical, {1000, 2000});
  ASSERT_EQ(margin.inside.size(), 2U);  // the ends count
  EXPECT_EQ(margin.inside[0].speed, 990);
  EXPECT_EQ(margin.inside[1].speed, 1500);
  ASSERT_TRUE(margin.below && margin.above);
  EXPECT_EQ(margin.below->speed, 890);
  EXPECT_NEAR(margin.below->margin, 0.1, rounding);
  EXPECT_EQ(margin.above->speed, 2205);
  EXPECT_NEAR(margin.above->margin, 0.1, rounding);
}

}  // namespace
}  // namespace tiprub::postprocess::critical_speeds_test
