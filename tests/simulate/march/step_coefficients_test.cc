// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/step_coefficients.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace tiprub::simulate::step_coefficients_test {
namespace {

struct Mode {
  double omega, ratio, step;
  StepCoefficients of(Scheme scheme) const {
    return step_coefficients({scheme}, Eigen::ArrayXd::Constant(1, omega), Eigen::ArrayXd::Constant(1, ratio), step,
                             1);
  }
};

/// A mode and its increment, step by step under a force.
struct Motion {
  StepCoefficients at;
  double now, increment;
  double step(double force = 0) {
    increment -= at.r[0] * increment + at.k[0] * now - at.c[0] * force;
    return now += increment;
  }
};

/// Exact: q'' + 2 z w q' + w^2 q = 0 from q(0) = 1, q'(0) = 0.
double decay(const Mode& mode, double time) {
  const std::complex<double> root = std::sqrt(std::complex<double>(mode.ratio * mode.ratio - 1));
  const std::complex<double> s1 = mode.omega * (-mode.ratio + root), s2 = mode.omega * (-mode.ratio - root);
  return ((s1 * std::exp(s2 * time) - s2 * std::exp(s1 * time)) / (s1 - s2)).real();
}

TEST(Trigonometric, IsExactInFreeFlightOfWhatTheStepResolves) {
  for (const Mode& mode :
       {Mode{100, 0.0, 1e-3}, Mode{100, 0.01, 2e-2}, Mode{100, 0.3, 2.3e-2}, Mode{100, 1.7, 1e-2}}) {
    const double first = decay(mode, mode.step);
    Motion motion{mode.of(Scheme::trigonometric), first, first - 1};
    for (int i = 2; i < 200; ++i) {
      ASSERT_NEAR(motion.step(), decay(mode, i * mode.step), 1e-11) << "ratio " << mode.ratio << ", step " << i;
    }
  }
}

TEST(Trigonometric, EndsInTheStaticDeflection) {
  for (const Mode& mode : {Mode{100, 0.0, 1e-9}, Mode{100, 0.02, 1e-3}, Mode{100, 0.5, 1.0}, Mode{100, 2.0, 1e-2}}) {
    const StepCoefficients at = mode.of(Scheme::trigonometric);
    EXPECT_GE(at.c[0], 0);
    EXPECT_NEAR(at.c[0] * mode.omega * mode.omega, at.k[0], 4e-16);
  }
}

TEST(Trigonometric, KeepsTheComplianceOfWhatTheStepCantResolve) {
  for (int tenths = 24; tenths < 1000; ++tenths) {
    const double angle = 0.1 * tenths;
    const StepCoefficients at = Mode{angle, 0.005, 1.0}.of(Scheme::trigonometric);
    EXPECT_GT(at.c[0] * angle * angle, 1.9) << angle;  // of the static compliance; 0 at 2 pi if flight were exact
    EXPECT_LT(std::abs(2 - at.r[0] - at.k[0]), 2 - at.r[0]) << angle << ": a mode that swings and dies out";
  }
}

TEST(Trigonometric, MovesAFreeMassByNewton) {
  const StepCoefficients at = Mode{0, 0.1, 1e-3}.of(Scheme::trigonometric);
  EXPECT_EQ(at.r[0], 0.0);
  EXPECT_EQ(at.k[0], 0.0);
  EXPECT_EQ(at.c[0], 1e-6);
}

TEST(Trigonometric, KeepsItsDigitsAtTinySteps) {
  const double angle = 1e-7, ratio = 0.01;
  for (const Scheme scheme : {Scheme::trigonometric, Scheme::central_differences, Scheme::moreau_jean}) {
    const StepCoefficients at = Mode{1, ratio, angle}.of(scheme);
    EXPECT_NEAR(at.c[0] / (angle * angle), 1.0, 1e-8);
    EXPECT_NEAR(at.k[0] / at.c[0], 1.0, 1e-15);
    EXPECT_NEAR(at.r[0] / (2 * ratio * angle), 1.0, 1e-8);
  }
}

/// eq. 13 for one degree of freedom, m = 1.
TEST(CentralDifferences, AreThePapersEquation13) {
  const double h = 1e-3, w = 300, z = 0.02, D = 2 * z * w, K = w * w;
  const StepCoefficients at = Mode{w, z, h}.of(Scheme::central_differences);
  const double divisor = 1 / (h * h) + D / (2 * h);
  EXPECT_NEAR(2 - at.r[0] - at.k[0], (2 / (h * h) - K) / divisor, 1e-14);
  EXPECT_NEAR(1 - at.r[0], -(D / (2 * h) - 1 / (h * h)) / divisor, 1e-14);
  EXPECT_NEAR(at.c[0] * divisor, 1.0, 1e-14);
}

/// Error after a fixed time under a harmonic force, q'' + 2 z w q' + w^2 q = cos(W t), from the exact steady motion.
double forced_error(Scheme scheme, int steps) {
  const double w = 100, z = 0.05, W = 70, time = 0.2;
  const Mode mode{w, z, time / steps};
  const std::complex<double> amplitude = 1.0 / std::complex<double>(w * w - W * W, 2 * z * w * W);
  const auto exact = [&](double t) { return (amplitude * std::polar(1.0, W * t)).real(); };
  Motion motion{mode.of(scheme), exact(mode.step), exact(mode.step) - exact(0)};
  for (int i = 1; i < steps; ++i) motion.step(std::cos(W * i * mode.step));
  return std::abs(motion.now - exact(time)) / std::abs(amplitude);
}

TEST(Schemes, AreOfOrderTwo) {
  for (Scheme scheme : {Scheme::trigonometric, Scheme::central_differences}) {
    const double order = std::log2(forced_error(scheme, 400) / forced_error(scheme, 800));
    EXPECT_NEAR(order, 2.0, 0.05);
  }
}

TEST(CentralDifferences, HoldJustBelowTheirLimitAndNotAbove) {
  const auto amplitude = [](double ratio) {
    const StepCoefficients at = Mode{1, 0.0, 2 * ratio}.of(Scheme::central_differences);
    Motion motion{at, 1 - at.k[0] / 2, -at.k[0] / 2};
    for (int i = 0; i < 2000; ++i) motion.step();
    return std::abs(motion.now);
  };
  EXPECT_LT(amplitude(0.997), 100);
  EXPECT_GT(amplitude(1.003), 1e6);
}

}  // namespace
}  // namespace tiprub::simulate::step_coefficients_test
