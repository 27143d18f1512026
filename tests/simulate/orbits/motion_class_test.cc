// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/motion_class.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace tiprub::simulate {
namespace {

constexpr int samples = 240, lobes = 2;
constexpr double turn = 2 * std::numbers::pi;

/// Two channels of a motion over turns of the rotor.
std::deque<Eigen::VectorXd> revolutions(int count, const std::function<double(double)>& motion) {
  std::deque<Eigen::VectorXd> all;
  for (int r = 0; r < count; ++r) {
    Eigen::VectorXd one(2 * samples);
    for (int s = 0; s < samples; ++s) {
      const double angle = turn * (r + static_cast<double>(s) / samples);
      one[2 * s] = motion(angle);
      one[2 * s + 1] = 0.5 * motion(angle + 0.3);
    }
    all.push_back(one);
  }
  return all;
}

double driven(double angle) {
  return std::cos(2 * angle) + 0.3 * std::cos(6 * angle);
}

TEST(MotionClass, CountsThePeriodInBeats) {
  // twice the lobes' period is one revolution: with the period in revolutions it passed for periodic
  const auto motion = [](double angle) { return driven(angle) + std::cos(3 * angle); };
  const MotionReading reading = read_motion(revolutions(1, motion), 2, 60, lobes, Change::settled);
  EXPECT_EQ(reading.motion, MotionClass::subharmonic);
  EXPECT_EQ(reading.period_beats, 2);
  EXPECT_NEAR(reading.off_beat_energy, 1 / 2.09, 1e-3);
  const MotionReading plain = read_motion(revolutions(1, driven), 2, 60, lobes, Change::settled);
  EXPECT_EQ(plain.motion, MotionClass::periodic);
  EXPECT_EQ(plain.period_beats, 1);
  EXPECT_LT(plain.off_beat_energy, 1e-20);
}

TEST(MotionClass, CallsWhatBarelyLeavesTheEngineOrdersPeriodicThoughItNeverSettles) {
  std::mt19937 source(1);
  const auto motion = [&](double angle) { return driven(angle) + 2e-3 * (2.0 * source() / std::mt19937::max() - 1); };
  const MotionReading reading = read_motion(revolutions(24, motion), 2, 60, lobes, Change::stands);
  EXPECT_EQ(reading.motion, MotionClass::periodic);
  EXPECT_GT(reading.off_beat_energy, 0);
}

TEST(MotionClass, TellsAFewLinesFromMany) {
  const auto modulated = [](double angle) { return driven(angle) * (1 + 0.2 * std::cos(0.317 * angle)); };
  EXPECT_EQ(read_motion(revolutions(24, modulated), 2, 60, lobes, Change::stands).motion, MotionClass::modulated);
  std::mt19937 source(1);
  const auto broadband = [&](double angle) { return driven(angle) + 2.0 * source() / std::mt19937::max(); };
  EXPECT_EQ(read_motion(revolutions(24, broadband), 2, 60, lobes, Change::stands).motion, MotionClass::broadband);
}

/// Symptom: with one lobe, half of all modulated motions were said to be subharmonic 1/7: within Hann's width of all
/// of its multiples there was hardly a line that could contradict.
TEST(MotionClass, NeedsLinesThatCouldContradictAPeriod) {
  std::mt19937 source(1);
  constexpr int motions = 200;
  int modulated = 0;
  for (int i = 0; i < motions; ++i) {
    const double order = 2 + 3.0 * source() / std::mt19937::max();
    const auto motion = [order](double angle) {
      return std::cos(angle) + 0.3 * std::cos(2 * angle) + 0.5 * std::cos(order * angle + 1) +
             0.2 * std::cos((order - 1) * angle);
    };
    const MotionReading reading = read_motion(revolutions(24, motion), 2, 60, 1, Change::stands);
    modulated += reading.motion == MotionClass::modulated ? 1 : 0;
  }
  EXPECT_GT(modulated, 0.8 * motions);
}

TEST(MotionClass, LeavesADecayingMotionOpen) {
  const auto motion = [](double angle) { return driven(angle) + std::exp(-angle / 100) * std::cos(3.3 * angle); };
  EXPECT_EQ(read_motion(revolutions(24, motion), 2, 60, lobes, Change::decays).motion, MotionClass::not_settled);
}

TEST(MotionClass, LeavesWhatIsAboveTheBandOut) {
  const auto motion = [](double angle) { return driven(angle) + std::cos(41 * angle); };
  EXPECT_EQ(read_motion(revolutions(1, motion), 2, 20, lobes, Change::settled).motion, MotionClass::periodic);
  EXPECT_EQ(read_motion(revolutions(1, motion), 2, 60, lobes, Change::settled).motion, MotionClass::subharmonic);
}

/// Symptom once: Moreau-Jean, whose pressed tips jitter by a percent or two, called subharmonic what is periodic.
TEST(MotionClass, ForgivesAJitter) {
  const auto motion = [](double angle) { return driven(angle) + 0.02 * std::cos(3.5 * angle); };
  const auto with = [&](double off_lines) {
    return read_motion(revolutions(2, motion), 2, 60, lobes, Change::settled, off_lines).motion;
  };
  EXPECT_EQ(with(ClassLimits::off_lines), MotionClass::subharmonic);
  EXPECT_EQ(with(ClassLimits::off_jitter), MotionClass::periodic);
}

TEST(EngineOrderBand, KeepsTheSumOfSquaresOfItsOrders) {
  const EngineOrderBand band(samples, 10);
  const auto mean_over_a_sample = [](double order) {
    const double half = std::numbers::pi * order / samples;
    return std::sin(half) / half;
  };
  Eigen::VectorXd motion(samples);
  for (int s = 0; s < samples; ++s)
    motion[s] =
        0.7 + 2 * mean_over_a_sample(8) * std::cos(8 * turn * s / samples) + std::cos(30 * turn * s / samples);
  EXPECT_NEAR(band.coefficients(motion).squaredNorm(), samples * (0.49 + 2.0), 1e-9);
}

}  // namespace
}  // namespace tiprub::simulate
