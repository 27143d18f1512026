// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of a peak whose samples are as far apart as they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/report/report.h"
#include "postprocess/tables/table.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess {
namespace {

constexpr double damping = 0.005;

/// [rpm, mm]
using Sample = std::pair<double, double>;
using Curve = std::function<double(double rpm)>;

/// A response whose amplitude goes through these samples, in one wave, of a wheel with that damping.
Response through(const std::vector<Sample>& samples) {
  static const ReducedModel rotor = synthetic::model();
  Response response{synthetic::two_lobes(), "made", {}, synthetic::frequencies(rotor)};
  for (const Eigen::MatrixXd& modes : response.frequencies.by_nodal_diameter)
    response.frequencies.damping_ratio.emplace_back(Eigen::MatrixXd::Constant(modes.rows(), modes.cols(), damping));
  for (const auto& [rpm, mm] : samples)
    response.speeds.push_back(
        synthetic::speed(response.scene, rotor.contact, rpm * rad_s_per_rpm, {{6, -4, mm / mm_per_m, 0}}, 1));
  return response;
}

Study study_of(Response response) {
  return make_study({}, synthetic::model(), std::move(response), {});
}

Study study_of(const std::vector<Sample>& samples) {
  return study_of(through(samples));
}

/// `count` even speeds from 12,000 to 18,000 rpm.
std::vector<Sample> even(int count, const Curve& curve) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double rpm = 12000 + 6000.0 * i / (count - 1);
    samples.emplace_back(rpm, curve(rpm));
  }
  return samples;
}

/// A resonance of the wheel's damping over a floor of a tenth.
Curve resonance(double top) {
  return [top](double rpm) { return 0.01 + 0.09 / std::hypot(1, (rpm / top - 1) / damping); };
}

/// Symptom: 11,545 rpm "-134 +40", 0.0424 mm "within 1.6 %"; the peak was at 11,169 rpm with 0.0826 mm. Cause:
/// located was where the straight line between two samples had fallen by 2 %, and the amplitude's range was that of
/// the step.
TEST(SpeedSpacing, NoIntervalIsNarrowerThanTheNeighbours) {
  std::mt19937 random(5);
  int found = 0;
  for (const int count : {7, 12, 27, 53, 121, 401}) {
    for (int trial = 0; trial < 8; ++trial) {
      const double top = std::uniform_real_distribution(13500.0, 16500.0)(random);
      const Study study = study_of(even(count, resonance(top)));
      for (const CriticalSpeed& peak : study.critical) {
        ++found;
        EXPECT_LE(peak.speed_low, top * rad_s_per_rpm) << count;
        EXPECT_GE(peak.speed_high, top * rad_s_per_rpm) << count;
        EXPECT_LE(peak.speed_low, study.speed_at(peak.index - 1).speed);
        EXPECT_GE(peak.speed_high, study.speed_at(peak.index + 1).speed);
        EXPECT_GE(peak.amplitude_high * mm_per_m, resonance(top)(top)) << count;
        EXPECT_LE(peak.amplitude_low * mm_per_m, resonance(top)(top)) << count;
      }
    }
  }
  EXPECT_GT(found, 20);
}

/// The tops that single speeds 1 rpm apart found between the samples of an adaptive sweep of cases/impeller_quick.
TEST(SpeedSpacing, TheAmplitudesRangeHasWhatSingleSpeedsFound) {
  const std::vector<std::pair<std::vector<Sample>, Sample>> found = {{{{9000, 0.0155},
                                                                       {9275.6, 0.02502},
                                                                       {9292.8, 0.03188},
                                                                       {9301.1, 0.041617},
                                                                       {9305.2, 0.041691},
                                                                       {9309.5, 0.041437},
                                                                       {9317.9, 0.039361},
                                                                       {9500, 0.0206}},
                                                                      {9303, 0.04189}},
                                                                     {{{19000, 0.058036},
                                                                       {19250, 0.133328},
                                                                       {19500, 0.183718},
                                                                       {19514.6, 0.186925},
                                                                       {19524.8, 0.189209},
                                                                       {19532.1, 0.190735},
                                                                       {19549.7, 0.146502},
                                                                       {19750, 0.101594},
                                                                       {19950, 0.0933}},
                                                                      {19538, 0.19180}}};
  for (const auto& [samples, top] : found) {
    const Study study = study_of(samples);
    ASSERT_EQ(study.critical.size(), 1u);
    const CriticalSpeed& peak = study.critical.front();
    EXPECT_LE(peak.speed_low * rpm_per_rad_s, top.first);
    EXPECT_GE(peak.speed_high * rpm_per_rad_s, top.first);
    EXPECT_GE(peak.amplitude_high * mm_per_m, top.second);
    EXPECT_LT(peak.amplitude_high, 1.03 * peak.amplitude);
  }
}

/// Symptom: a critical speed "-2863 +5377" of a motion that half the step changed by half.
TEST(SpeedSpacing, APeakThatDoesNotFallClearlyIsNoCriticalSpeed) {
  Response response = through({{14000, 0.01},
                               {15000, 0.02},
                               {15100, 0.03},
                               {15200, 0.02},
                               {16000, 0.06},
                               {17000, 0.1},
                               {18000, 0.05},
                               {19000, 0.02},
                               {20000, 0.01}});
  EXPECT_EQ(study_of(response).critical.size(), 2u);
  response.speeds[2].audit.halving_difference = 0.5;
  const Study study = study_of(std::move(response));
  ASSERT_EQ(study.critical.size(), 1u);
  EXPECT_NEAR(study.critical.front().speed * rpm_per_rad_s, 17000, 1);
  ASSERT_EQ(study.not_located.size(), 1u);
  EXPECT_NEAR(study.not_located.front().speed * rpm_per_rad_s, 15100, 1);
  const std::string how_bad = verdict(study, field_results(std::nullopt, study.critical), {})[1].text;
  EXPECT_NE(how_bad.find("Not located, and no critical speeds: 0.030 mm at 15100 rpm"), std::string::npos) << how_bad;
}

/// Symptom: the table of a wheel was silent of engine order 9, which was still rising at the design speed.
TEST(SpeedSpacing, ThePrintedTableTellsWhereTheResponseStillRises) {
  const Study risen = study_of({{12000, 0.01}, {13000, 0.04}, {14000, 0.01}, {15000, 0.02}, {16000, 0.03}});
  const FieldResults none = field_results(std::nullopt, risen.critical);
  const std::string printed = printed_critical_speeds(risen, none);
  EXPECT_NE(printed.find("\nThe amplitude still rises towards 16000 rpm (0.030 mm): a peak may lie outside"),
            std::string::npos)
      << printed;
  const Study fallen = study_of({{12000, 0.01}, {13000, 0.04}, {14000, 0.01}, {15000, 0.01}, {16000, 0.01}});
  EXPECT_EQ(printed_critical_speeds(fallen, field_results(std::nullopt, fallen.critical)).find("still rises"),
            std::string::npos);
}

TEST(SpeedSpacing, AnIntervalOverMostOfTheRangeLocatesNothing) {
  const Study study = study_of({{12000, 0.01}, {14000, 0.02}, {16000, 0.08}, {18000, 0.01}});
  EXPECT_TRUE(study.critical.empty());
  EXPECT_EQ(study.not_located.size(), 1u);
}

int passed(const Study& study) {
  const std::vector<Check> checks = exactness_checks(study);
  return static_cast<int>(std::count_if(checks.begin(), checks.end(),
                                        [](const Check& check) { return check.verdict == CheckVerdict::passed; }));
}

const Check& check_of(const std::vector<Check>& checks, const std::string& subject) {
  return *std::find_if(checks.begin(), checks.end(), [&](const Check& check) { return check.subject == subject; });
}

/// Symptom: 27 speeds passed 9 checks of 11, and the finer sweep, which saw where the motion doesn't settle, 7.
TEST(SpeedSpacing, FinerGridsGetNoWorseMarks) {
  int best = 0;
  for (const int count : {7, 12, 27, 53, 401}) {
    Response response = through(even(count, resonance(14711)));
    for (SpeedResponse& speed : response.speeds)
      if (std::abs(speed.speed * rpm_per_rad_s / 14711 - 1) < 2e-3) {
        speed.period_revolutions = 0;  // only fine grids see it
        speed.audit.halving_difference = 0.1;
      }
    const Study study = study_of(std::move(response));
    const std::vector<Check> checks = exactness_checks(study);
    EXPECT_EQ(checks.front().subject, "speeds beside each peak");
    const bool fine = count > 400;
    EXPECT_EQ(speeds_too_far_apart(study), !fine) << count;
    EXPECT_EQ(checks.front().verdict == CheckVerdict::passed, fine) << count;
    EXPECT_EQ(check_of(checks, "speeds over the range").verdict == CheckVerdict::passed, count > 50) << count;
    EXPECT_EQ(check_of(checks, "unsettled motion").verdict == CheckVerdict::passed, false) << count;
    EXPECT_GE(passed(study), best) << count;
    best = passed(study);
  }
  EXPECT_GT(best, 2);
}

TEST(SpeedSpacing, WhatIsTooFarApartIsSaidFirst) {
  const Study coarse = study_of(even(27, resonance(14711))), fine = study_of(even(401, resonance(14711)));
  const auto first = [](const Study& study) {
    return verdict(study, field_results(std::nullopt, study.critical), {}).front();
  };
  EXPECT_EQ(first(fine).question, "How bad");
  EXPECT_EQ(speeds_caveat(fine), "");
  EXPECT_EQ(first(coarse).question, "Not trustworthy");
  EXPECT_NE(first(coarse).text.find("speeds beside each peak (2.97 at 14769 rpm, limit 0.5; 1 speed of 1)"),
            std::string::npos)
      << first(coarse).text;
  EXPECT_EQ(speeds_caveat(coarse), " (not trustworthy: speeds too far apart)");
}

/// Symptom: of 153 speeds, a block that had failed counted as simulated, and a resonance in it was said to be
/// excluded.
TEST(SpeedSpacing, FailedSpeedsLeaveAGap) {
  for (const bool fail : {false, true}) {
    Response response = through(even(401, resonance(14711)));
    if (fail)
      for (std::size_t k = 200; k < 300; ++k) response.speeds[k].failure = "diverged";
    const std::vector<Check> checks = exactness_checks(study_of(std::move(response)));
    EXPECT_EQ(check_of(checks, "speeds over the range").verdict, fail ? CheckVerdict::failed : CheckVerdict::passed);
  }
}

/// Symptom: a report said that sweeps reach the same motions where no speed had been compared.
TEST(SpeedSpacing, SweepsAreToldWithTheNumberOfSpeedsThatTheyShare) {
  Study study = study_of(even(27, resonance(14711)));
  const auto tells = [&](const std::string& sentence) {
    const std::vector<std::string> lines = summary(study);
    return std::find(lines.begin(), lines.end(), sentence) != lines.end();
  };
  study.sweeps.assign(3, SweepComparison());
  EXPECT_TRUE(tells("The sweeps share no speed with the response from rest."));
  study.sweeps[1].up = SweptSpeed();
  EXPECT_TRUE(tells("At 1 speed of 3, sweeps reach the same motions as marches from rest."));
}

/// Symptom: without damping, where a resonance has no width, the distance of the speeds was not looked at.
TEST(SpeedSpacing, IsNeverNarrowEnoughWithoutDamping) {
  Response response = through(even(401, resonance(14711)));
  for (Eigen::MatrixXd& ratios : response.frequencies.damping_ratio) ratios.setZero();
  EXPECT_NE(speeds_warning(study_of(std::move(response))).find("speeds over the range (400 speeds of 400)"),
            std::string::npos);
}

TEST(SpeedSpacing, TheMarginIsNotTrustedEither) {
  PostprocessParameters parameters;
  parameters.operating_min_rpm = 13000;
  parameters.operating_max_rpm = 14000;
  const Study coarse = make_study(parameters, synthetic::model(), through(even(27, resonance(14711))), {});
  std::string margin;
  for (const Answer& answer : verdict(coarse, field_results(std::nullopt, coarse.critical), {}))
    if (answer.question == "Margin") margin = answer.text;
  EXPECT_NE(margin.find("% away (not trustworthy: speeds too far apart)"), std::string::npos) << margin;
}

/// What an adaptive sweep scanned counts as looked at.
TEST(SpeedSpacing, ScannedSpeedsCloseTheRange) {
  Response response = through(even(27, [](double rpm) { return 1e-6 * rpm; }));
  EXPECT_TRUE(speeds_too_far_apart(study_of(response)));
  response.scanned_speeds = Eigen::VectorXd::LinSpaced(209, 12000 * rad_s_per_rpm, 18000 * rad_s_per_rpm);
  response.scanned_amplitudes = Eigen::VectorXd::Zero(209);
  EXPECT_FALSE(speeds_too_far_apart(study_of(response)));
}

/// Symptom: the report of a wheel whose tips never touch began "Not trustworthy. The speeds are too far apart".
TEST(SpeedSpacing, NothingIsMissedWhereNoTipTouches) {
  Response response = through(even(5, [](double) { return 0.0; }));
  EXPECT_TRUE(speeds_too_far_apart(study_of(response)));
  for (SpeedResponse& speed : response.speeds) speed.clearance.array() += response.scene.casing_distortion.maxCoeff();
  const Study study = study_of(std::move(response));
  const Answer first = verdict(study, field_results(std::nullopt, study.critical), {}).front();
  EXPECT_EQ(first.question, "How bad");
  EXPECT_EQ(
      first.text,
      "No tip touches the casing at any speed, so that nothing excites the wheel: a tip that does not vibrate stays "
      "at least 0.260 mm away from it.");
}

/// Without damping no spacing resolves a peak, and none is too wide by a number.
TEST(SpeedSpacing, IsUnknownWithoutDamping) {
  Response response = through(even(27, resonance(14711)));
  for (Eigen::MatrixXd& ratios : response.frequencies.damping_ratio) ratios.setZero();
  const Study study = study_of(std::move(response));
  ASSERT_FALSE(study.critical.empty());
  EXPECT_FALSE(study.critical[0].spacing_over_half_width());
  EXPECT_TRUE(std::isfinite(study.critical[0].amplitude_high));
  for (const Check& check : exactness_checks(study)) {
    EXPECT_TRUE(std::isfinite(check.worst.value_or(0))) << check.subject;
    EXPECT_FALSE(check.subject.starts_with("speeds") && check.verdict == CheckVerdict::passed) << check.subject;
  }
}

/// The report shows another component, which no clearance limits.
TEST(SpeedSpacing, AnotherComponentIsNoMotionTowardsTheCasing) {
  PostprocessParameters parameters;
  for (const auto& [component, text] : {std::pair(Component::normal, " mm in all, and towards the casing by "),
                                        {Component::axial, " mm in all; the axial displacement is "}}) {
    parameters.component = component;
    const Study study = make_study(parameters, synthetic::model(), synthetic::resonant_sweep(synthetic::model()), {});
    const Answer first = verdict(study, field_results(std::nullopt, study.critical), {}).front();
    EXPECT_NE(first.text.find(text), std::string::npos) << first.text;
    EXPECT_EQ(first.text.find("running clearance") == std::string::npos, component == Component::axial) << first.text;
  }
}

}  // namespace
}  // namespace tiprub::postprocess
