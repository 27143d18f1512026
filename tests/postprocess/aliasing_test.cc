// SPDX-License-Identifier: GPL-3.0-or-later
// Engine orders and nodal diameters: eq. 16 to eq. 21. Checks 43-47 and 54.
#include "postprocess/waves/aliasing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "postprocess/waves/travelling_spectrum.h"

namespace tiprub::postprocess {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

TEST(Aliasing, TenBladesCannotTellSixFromFour) {
  for (int j = 0; j < 10; ++j) {
    EXPECT_NEAR(std::cos(6 * two_pi * j / 10), std::cos(4 * two_pi * j / 10), 1e-14);
    EXPECT_NEAR(std::cos(8 * two_pi * j / 10), std::cos(2 * two_pi * j / 10), 1e-14);
  }
}

TEST(Aliasing, IsTheZigZagOfTheTenBlades) {
  const int zigzag[] = {0, 1, 2, 3, 4, 5, 4, 3, 2, 1};
  for (int order = 0; order <= 40; ++order) EXPECT_EQ(aliased_nodal_diameter(order, 10), zigzag[order % 10]);
}

TEST(Aliasing, TwoAndThreeLobes) {
  const int two[] = {2, 4, 4, 2, 0, 2}, three[] = {3, 4, 1, 2, 5, 2, 1, 4, 3, 0};
  for (int k = 1; k <= 6; ++k) EXPECT_EQ(aliased_nodal_diameter(2 * k, 10), two[k - 1]);
  for (int k = 1; k <= 10; ++k) EXPECT_EQ(aliased_nodal_diameter(3 * k, 10), three[k - 1]);
}

/// eq. 17, a N +- n = k N_l: the nodal diameter that an engine order reaches, and no other one, solves it.
TEST(Aliasing, TheNodalDiameterSolvesEquation17) {
  for (const int sectors : {1, 2, 7, 10, 13})
    for (int lobes = 1; lobes <= 6; ++lobes)
      for (int k = 1; k <= 2 * sectors; ++k)
        for (int n = 0; n <= sectors / 2; ++n) {
          const bool solves = (k * lobes - n) % sectors == 0 || (k * lobes + n) % sectors == 0;
          EXPECT_EQ(aliased_nodal_diameter(k * lobes, sectors) == n, solves) << sectors << " " << lobes << " " << n;
        }
}

TEST(Aliasing, DirectionOfTheEngineOrders) {
  for (int order = 1; order <= 30; ++order) {
    const WaveDirection direction = wave_direction(signed_nodal_diameter(order, 10), 10);
    const int place = order % 10;
    const WaveDirection expected = place == 0 || place == 5 ? WaveDirection::standing
                                   : place < 5              ? WaveDirection::backward
                                                            : WaveDirection::forward;
    EXPECT_EQ(direction, expected) << "EO " << order;
  }
  EXPECT_EQ(signed_nodal_diameter(3, 10), 3);
  EXPECT_EQ(signed_nodal_diameter(6, 10), -4);
  EXPECT_EQ(signed_nodal_diameter(9, 10), -1);
  EXPECT_EQ(signed_nodal_diameter(12, 10), 2);
}

/// The paper's appendix, table 1: ten oscillators m x'' + c x = f (eq. 18) under f_i = F cos(p (omega t + i alpha))
/// (eq. 21) move on one nodal diameter of the expansion eq. 19, with the amplitude F/(c - m p^2 omega^2); from p = 6
/// on, on the aliased one.
TEST(Aliasing, TenOscillatorsAnswerOnTheAliasedNodalDiameter) {
  constexpr int oscillators = 10, samples = 64;
  constexpr double mass = 2, stiffness = 5, force = 3, omega = 0.3;
  for (int p = 1; p <= 10; ++p) {
    const double receptance = 1 / (stiffness - mass * p * p * omega * omega);
    Eigen::MatrixXd motion(samples, oscillators);
    for (int s = 0; s < samples; ++s)
      for (int i = 0; i < oscillators; ++i) {
        const double excitation =
            force * std::cos(p * two_pi * (1.0 * s / samples + 1.0 * i / oscillators));  // eq. 21
        motion(s, i) = receptance * excitation;
        const double acceleration = -p * p * omega * omega * motion(s, i);
        ASSERT_NEAR(mass * acceleration + stiffness * motion(s, i), excitation, 1e-13);  // eq. 18
      }
    const TravellingSpectrum spectrum = travelling_spectrum(motion, 1);
    const double amplitude = std::abs(force * receptance);
    EXPECT_NEAR(spectrum.at(p, signed_nodal_diameter(p, oscillators)), amplitude, 1e-12 * amplitude) << "p = " << p;
    EXPECT_NEAR(spectrum.amplitude.sum(), amplitude, 1e-10 * amplitude) << "p = " << p;  // eq. 20: one wave alone
  }
}

}  // namespace
}  // namespace tiprub::postprocess
