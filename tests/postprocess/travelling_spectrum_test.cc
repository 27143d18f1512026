// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/travelling_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "postprocess/waves/aliasing.h"
#include "synthetic_scene.h"

namespace tiprub::postprocess::travelling_spectrum_test {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double round_off = 1e-12;

/// u_j(t_s) = amplitude cos(k Omega t + n j alpha + phase) on whole revolutions.
Eigen::MatrixXd made_wave(int sectors, int samples, int revolutions, double engine_order, int n, double amplitude,
                          double phase = 0.4) {
  Eigen::MatrixXd motion(samples * revolutions, sectors);
  for (int s = 0; s < motion.rows(); ++s)
    for (int j = 0; j < sectors; ++j)
      motion(s, j) =
          amplitude * std::cos(two_pi * (engine_order * s / samples + static_cast<double>(n) * j / sectors) + phase);
  return motion;
}

/// The wave alone has its amplitude; everything else is round-off.
void expect_only(const TravellingSpectrum& spectrum, double engine_order, int n, double amplitude) {
  EXPECT_NEAR(spectrum.at(engine_order, n), amplitude, round_off);
  EXPECT_NEAR(spectrum.amplitude.sum(), amplitude, round_off * static_cast<double>(spectrum.amplitude.size()));
}

TEST(TravellingSpectrum, FindsEveryTravellingWaveOfAnEvenWheel) {
  for (int n = -4; n <= 4; ++n) expect_only(travelling_spectrum(made_wave(10, 64, 1, 7, n, 2.5), 1), 7, n, 2.5);
}

TEST(TravellingSpectrum, FindsEveryTravellingWaveOfAnOddWheel) {
  for (int n = -4; n <= 4; ++n) expect_only(travelling_spectrum(made_wave(9, 63, 2, 5, n, 1.5), 2), 5, n, 1.5);
}

TEST(TravellingSpectrum, PutsASubharmonicOnItsFraction) {
  expect_only(travelling_spectrum(made_wave(10, 60, 4, 2.25, -3, 1.0), 4), 2.25, -3, 1.0);
  EXPECT_EQ(travelling_spectrum(made_wave(10, 60, 4, 2.25, -3, 1.0), 4).at(2.3, -3), 0.0);
}

/// In phase on every second sector: nodal diameter N/2 is one standing wave with its full amplitude.
TEST(TravellingSpectrum, StandingWaveOfHalfTheSectorsCountsOnce) {
  expect_only(travelling_spectrum(made_wave(10, 64, 1, 5, 5, 1.0), 1), 5, 5, 1.0);
}

/// A standing pattern cos(n j alpha) cos(w t) is two waves of half its amplitude, one each way.
TEST(TravellingSpectrum, StandingPatternIsOneWaveEachWay) {
  const Eigen::MatrixXd motion = made_wave(10, 64, 1, 6, 3, 0.5) + made_wave(10, 64, 1, 6, -3, 0.5);
  const TravellingSpectrum spectrum = travelling_spectrum(motion, 1);
  EXPECT_NEAR(spectrum.at(6, 3), 0.5, round_off);
  EXPECT_NEAR(spectrum.at(6, -3), 0.5, round_off);
}

/// The direction by its meaning, not by its formula: the crest of a positive nodal diameter moves to lower sectors,
/// that is, against the rotation (sector j lies j alpha ahead); and a pattern that stands in the casing, cos(k
/// theta_abs) with theta_abs = j alpha + Omega t, gives +4 on EO 4 and -4 on EO 6 for N = 10.
TEST(TravellingSpectrum, NamesTheDirectionAsSeenFromTheRotor) {
  const int samples = 720;
  for (const int n : {3, -3}) {
    const Eigen::MatrixXd motion = made_wave(360, samples, 1, 3, n, 1.0, 0.0);
    Eigen::Index before = 0, after = 0;  // the crest between two troughs, a moment apart
    motion.row(0).segment(61, 118).maxCoeff(&before);
    motion.row(4).segment(61, 118).maxCoeff(&after);
    if (n > 0) {
      EXPECT_LT(after, before);
    } else {
      EXPECT_GT(after, before);
    }
  }
  EXPECT_EQ(wave_direction(4, 10), WaveDirection::backward);
  EXPECT_EQ(wave_direction(-4, 10), WaveDirection::forward);
  for (const int k : {4, 6}) {
    Eigen::MatrixXd motion(samples, 10);
    for (int s = 0; s < samples; ++s)
      for (int j = 0; j < 10; ++j) motion(s, j) = std::cos(k * (two_pi * j / 10 + two_pi * s / samples));
    expect_only(travelling_spectrum(motion, 1), k, k == 4 ? 4 : -4, 1.0);
  }
}

TEST(TravellingSpectrum, KeepsTheMeanSquare) {
  for (const int sectors : {1, 2, 7, 10})
    for (const int samples : {48, 49}) {
      const Eigen::MatrixXd motion = Eigen::MatrixXd::Random(samples, sectors);
      const TravellingSpectrum spectrum = travelling_spectrum(motion, 1);
      double sum = 0;
      for (int line = 0; line < spectrum.lines(); ++line)
        sum += spectrum.amplitude.row(line).squaredNorm() / (line == 0 || 2 * line == samples ? 1.0 : 2.0);
      EXPECT_NEAR(sum, motion.squaredNorm() / static_cast<double>(motion.size()), 1e-13);
    }
}

/// Frequency clustering (check 51): two waves closer than the resolution of one revolution are one peak over time
/// alone, and two in space and time.
TEST(TravellingSpectrum, SeparatesCloseFrequenciesByNodalDiameter) {
  const Eigen::MatrixXd motion = made_wave(10, 64, 1, 6, 0, 1.0) + made_wave(10, 64, 1, 6.1, 2, 0.8);
  const Eigen::VectorXd one_way = line_spectrum(motion.col(0));
  EXPECT_GT(one_way[6], one_way[5]);
  EXPECT_GT(one_way[6], one_way[7]);  // one peak only
  const TravellingSpectrum two_way = travelling_spectrum(motion, 1);
  EXPECT_NEAR(two_way.at(6, 0), 1.0, 1e-9);
  EXPECT_NEAR(two_way.at(6, 2), 0.8, 0.05);
}

TEST(TravellingSpectrum, AddsTheDirectionsOfANodalDiameter) {
  const Eigen::MatrixXd motion = made_wave(10, 64, 1, 4, 4, 1.0) + made_wave(10, 64, 1, 4, -4, 0.25);
  const Eigen::MatrixXd parts = travelling_spectrum(motion, 1).by_nodal_diameter();
  ASSERT_EQ(parts.cols(), 6);
  EXPECT_NEAR(parts(4, 4), 1.25, round_off);
}

TEST(TravellingSpectrum, IsTheSameEveryTime) {
  const Eigen::MatrixXd motion = Eigen::MatrixXd::Random(360, 10);
  EXPECT_EQ(travelling_spectrum(motion, 1).amplitude, travelling_spectrum(motion, 1).amplitude);
}

/// A file holds N/g sectors; the others move as sector j mod (N/g). Expanded, the waves keep their amplitude.
TEST(TipMotion, ExpandsTheIndependentSectors) {
  const SimulatedScene scene = synthetic::two_lobes();
  const ReducedModel rotor = synthetic::model();
  const SpeedResponse at = synthetic::speed(scene, rotor.contact, 1500, {{6, -4, 2e-5, 0.3}, {4, 4, 1e-5, 0.1}});
  const TravellingSpectrum spectrum =
      travelling_spectrum(tip_motion(at, scene, rotor.contact, 0, Component::normal), 4);
  EXPECT_NEAR(spectrum.at(6, -4), 2e-5, 1e-15);
  EXPECT_NEAR(spectrum.at(4, 4), 1e-5, 1e-15);
  EXPECT_NEAR(spectrum.amplitude.sum(), 3e-5, 1e-14);
}

}  // namespace
}  // namespace tiprub::postprocess::travelling_spectrum_test
