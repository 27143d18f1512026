// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/adaptive_speeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace tiprub::simulate {
namespace {

using Curve = std::function<double(double)>;

/// A resonance at `speed` with the half-power width 2 `damping`.
double resonance(double x, double speed, double damping) {
  const double ratio = x / speed;
  return 1 / std::hypot(1 - ratio * ratio, 2 * damping * ratio);
}

using Amplitudes = std::map<double, double>;

SampledCurve list(const Amplitudes& amplitudes) {
  SampledCurve curve;
  for (const auto& [speed, amplitude] : amplitudes) curve.push_back({speed, amplitude});
  return curve;
}

/// What an adaptive sweep comes to: full speeds with their amplitudes. `scanned`: what the scan takes for the curve.
SampledCurve sweep(const Curve& curve, const LocationGoal& goal, const Curve& scanned) {
  Amplitudes full, scan;
  for (int i = 0; i <= 100; ++i) {
    const double x = 1000 + 10.0 * i;
    scan[x] = scanned(x);
    if (i % 5 == 0) full[x] = curve(x);
  }
  const auto add = [](Amplitudes& to, const std::vector<double>& speeds, const Curve& of) {
    for (const double x : speeds) to[x] = of(x);
    return !speeds.empty();
  };
  for (int round = 0; round < 100 && add(scan, speeds_to_refine(list(scan), goal.of_scan()), scanned);) ++round;
  add(full, speeds_to_confirm(list(scan), list(full), goal), curve);
  for (int round = 0; round < 100 && add(full, speeds_to_refine(list(full), goal), curve);) ++round;
  return list(full);
}

void expect_located(const SampledCurve& found, double speed, double height) {
  const LocationGoal goal;
  for (const std::size_t i : located_peaks(found, goal))
    if (std::abs(found[i].speed - speed) <= goal.speed * speed) {
      EXPECT_NEAR(found[i].amplitude, height, goal.amplitude * height);
      EXPECT_LE(found[i + 1].speed - found[i].speed, 1.01 * goal.speed * speed);
      EXPECT_LE(found[i].speed - found[i - 1].speed, 1.01 * goal.speed * speed);
      return;
    }
  ADD_FAILURE() << "no peak at " << speed;
}

TEST(AdaptiveSpeeds, LocatesPeaksBetweenSamples) {
  const Curve curve = [](double x) { return resonance(x, 1237.3, 0.004) + 0.6 * resonance(x, 1713.9, 0.002); };
  const SampledCurve found = sweep(curve, {}, curve);
  expect_located(found, 1237.3, curve(1237.3));
  expect_located(found, 1713.9, curve(1713.9));
  EXPECT_EQ(located_peaks(found, {}).size(), 2u);
  EXPECT_LT(found.size(), 60u);
}

TEST(AdaptiveSpeeds, AreNotMisledByAScanThatIsOffByPercents) {
  const Curve curve = [](double x) { return resonance(x, 1237.3, 0.01); };
  const Curve scanned = [&](double x) { return curve(x) * (1 + 0.03 * std::sin(x)); };
  expect_located(sweep(curve, {}, scanned), 1237.3, curve(1237.3));
}

/// A peak of the full-size impeller near 15,300 rpm, as marched: of its two tops the lower one was located, 15,386
/// rpm, and the higher one, 15,314 rpm, stayed between two samples.
double two_tops(double x) {
  const double speed = 15200 + 4 * (x - 1500);
  const std::vector<std::array<double, 2>> marched = {
      {14000, 0.030},  {15160, 0.0374}, {15200, 0.0378}, {15286, 0.0460}, {15300, 0.0468}, {15314, 0.0471},
      {15320, 0.0469}, {15372, 0.0453}, {15386, 0.0457}, {15414, 0.0448}, {15600, 0.0390}, {18000, 0.025}};
  std::size_t i = 1;
  while (i + 1 < marched.size() && marched[i][0] < speed) ++i;
  const auto &low = marched[i - 1], &high = marched[i];
  return low[1] + (high[1] - low[1]) * std::clamp((speed - low[0]) / (high[0] - low[0]), 0.0, 1.0);
}

TEST(AdaptiveSpeeds, FindTheHigherOfTwoTops) {
  const Curve scanned = [](double x) { return std::min(two_tops(x), two_tops(1500) + (x - 1500) * 1.6e-4); };
  expect_located(sweep(two_tops, {}, scanned), 1528.5, 0.0471);
}

TEST(AdaptiveSpeeds, EnclosesAJump) {
  const double fold = 1503.7;
  const Curve curve = [&](double x) { return x < fold ? 1 + (x - 1000) / 500 : 0.4; };
  const SampledCurve found = sweep(curve, {}, curve);
  const auto after = std::find_if(found.begin(), found.end(), [&](const auto& at) { return at.speed >= fold; });
  EXPECT_LE(after->speed - (after - 1)->speed, 1e-3 * fold);
}

TEST(AdaptiveSpeeds, StayWithinTheRangeBesideAJumpAtItsEnd) {
  const Curve curve = [](double x) { return x < 1998 ? 1 + (x - 1000) / 500 : 0.4; };
  const SampledCurve found = sweep(curve, {}, curve);
  EXPECT_EQ(found.front().speed, 1000);
  EXPECT_EQ(found.back().speed, 2000);
}

/// Symptom: a second peak with 84 % of the worst amplitude, 7 % above the valley between, was neither located nor
/// examined.
TEST(AdaptiveSpeeds, LocateAllThatIsNearlyAsSevereAsTheWorst) {
  const Curve curve = [](double x) {
    const auto top = [x](double height, double speed, double half_width) {
      return height / std::hypot(1, (x - speed) / half_width);
    };
    return std::max({top(1, 1503.3, 15), top(0.84, 1583.7, 15), top(0.78, 1530, 200)});
  };
  const SampledCurve found = sweep(curve, {}, curve);
  EXPECT_EQ(located_peaks(found, {}).size(), 2u);
  expect_located(found, 1503.3, 1);
  expect_located(found, 1583.7, 0.84);
}

/// Twice as many scanned speeds for half of the damping, where the first ones leave room for a peak.
TEST(AdaptiveSpeeds, ScanSoThatNoResonanceHidesBetween) {
  const std::vector<double> given = {1000, 1100, 1200};
  EXPECT_EQ(speeds_to_scan(given, 4, 0.02, 1000).size(), 11u);
  for (const double damping : {5e-3, 2.5e-3}) {
    std::vector<double> speeds = speeds_to_scan(given, 4, damping, 1000);
    std::sort(speeds.begin(), speeds.end());
    for (std::size_t i = 0; i + 1 < speeds.size(); ++i)
      EXPECT_LE(speeds[i + 1] - speeds[i], finding_spacing * damping * speeds[i]);
  }
  EXPECT_LE(speeds_to_scan(given, 4, 0, 100).size(), 100u);
  EXPECT_EQ(speeds_to_scan({1000}, 4, 0.01, 100), (std::vector<double>{1000}));
}

TEST(AdaptiveSpeeds, ResolveAPeakOfItsDamping) {
  for (const double damping : {0.05, 5e-3, 1e-3}) {
    const LocationGoal goal = LocationGoal::of_damping(damping);
    EXPECT_LE(goal.speed, resolving_spacing * damping);
    EXPECT_LE(goal.speed, 1e-3);
  }
}

TEST(AdaptiveSpeeds, AskForNothingOnASmoothCurve) {
  const Curve line = [](double x) { return x / 1000; };
  EXPECT_EQ(sweep(line, {}, line).size(), 21u);
}

}  // namespace
}  // namespace tiprub::simulate
