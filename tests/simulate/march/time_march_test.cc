// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/time_march.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::time_march_test {
namespace {

using testing::Bench;
using testing::make_bench;

constexpr double pi = std::numbers::pi;

/// Free decay of one mass against the closed form of the recurrence and, for the trigonometric scheme, of nature.
TEST(TimeMarch, DecaysFreelyAsTheClosedFormsSay) {
  const double mass = 0.02, stiffness = 8e4, ratio = 0.01, speed = 500;
  const double omega = std::sqrt(stiffness / mass), damped = omega * std::sqrt(1 - ratio * ratio);
  for (Scheme scheme : {Scheme::trigonometric, Scheme::central_differences}) {
    Bench bench = make_bench(testing::one_mass(mass, stiffness), testing::lobed_casing(1, 0.0, 1.0), speed, ratio,
                             {scheme, ContactRule::complementarity, 1600, 1});
    const double h = bench.march.time_step();
    const MarchedWave& wave = bench.march.wave(0);
    const double b = 1 - wave.coefficients.r[0], a = 1 + b - wave.coefficients.k[0];
    const std::complex<double> root =
        (a + std::sqrt(std::complex<double>(a * a - 4 * b))) / 2.0;  // r^2 - a r + b = 0
    const Eigen::VectorXcd now = Eigen::VectorXcd::Constant(3, 1e-3);
    bench.march.set_state(0, now, now * (1 - (1.0 / root).real()));
    const double scale = bench.rotor.waves[0].normal_rows.real().sum() * 1e-3;
    for (int i = 1; i <= 5000; ++i) {
      bench.march.step();
      ASSERT_NEAR(bench.march.displacement()[0] / scale, std::pow(root, i).real(), 1e-10);
    }
    if (scheme == Scheme::trigonometric) {
      EXPECT_NEAR(std::abs(root - std::polar(std::exp(-ratio * omega * h), damped * h)), 0, 1e-14);
    }
  }
}

/// Appendix A, Table 1: ten uncoupled oscillators under F cos(p (theta_j + Omega t)) show order p on one nodal
/// diameter, with the amplitude F/(k - p^2 m Omega^2); here F c/(e^{i phi} - a + b e^{-i phi}), its discrete form,
/// phi = p Omega h.
TEST(TimeMarch, ReproducesTheAliasingTableOfThePaper) {
  const int sectors = 10, steps = 2000;
  const double mass = 1.0, stiffness = 16.0, speed = 0.9, force = 1.0, ratio = 0.02;
  const struct { int order, diameter; } table[] = {{3, 3}, {6, 4}, {9, 1}, {12, 2}};
  for (const auto& [order, diameter] : table) {
    Bench bench = make_bench(testing::uncoupled_blades(sectors, mass, stiffness), testing::lobed_casing(1, 0.0, 1e3),
                             speed, ratio, {Scheme::trigonometric, ContactRule::complementarity, steps, 1});
    TimeMarch& march = bench.march;
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(sectors * march.width());
    std::vector<int> tips;
    for (int j = 0; j < sectors; ++j) tips.push_back(j * march.width());
    const int revolutions = 80;
    std::vector<std::complex<double>> seen(sectors / 2 + 1);
    for (int i = 0; i < revolutions * steps; ++i) {
      for (int j = 0; j < sectors; ++j)  // forces count against the normal
        forces[tips[j]] = -force * std::cos(order * 2 * pi * (i / double(steps) + j / double(sectors)));
      march.predict();
      march.correct(forces, tips);
      if (i < (revolutions - 1) * steps) continue;
      const auto at_order = std::polar(2.0 / steps, -order * 2 * pi * (i + 1) / steps);
      for (int n = 0; n <= sectors / 2; ++n)
        for (int j = 0; j < sectors; ++j)  // the signed wave that the order lives in, or its mirror image
          seen[n] += at_order * march.displacement()[tips[j]] *
                     std::polar(1.0 / sectors, -2 * pi * (order % sectors <= sectors / 2 ? n : -n) * j / sectors);
    }
    const MarchedWave& wave = march.wave(0);
    const double phi = order * speed * march.time_step();
    const double b = 1 - wave.coefficients.r[0], a = 1 + b - wave.coefficients.k[0];
    const std::complex<double> discrete =
        force / mass * wave.coefficients.c[0] / (std::polar(1.0, phi) - a + b * std::polar(1.0, -phi));
    const double exact = force / std::abs(stiffness - order * order * mass * speed * speed);
    for (int n = 0; n <= sectors / 2; ++n)
      EXPECT_NEAR(std::abs(seen[n] - (n == diameter ? discrete : 0.0)), 0, 1e-9 * std::abs(discrete))
          << "order " << order << ", nodal diameter " << n;
    EXPECT_NEAR(std::abs(discrete), exact, 0.02 * exact);
  }
}

/// In each step of a rubbing wheel: no negative multiplier, no penetration, no force on an open node.
TEST(TimeMarch, KeepsComplementarityInEveryStep) {
  const ReducedModel model = testing::synthetic_wheel({});
  for (Scheme scheme : {Scheme::trigonometric, Scheme::central_differences}) {
    Bench bench = make_bench(model, testing::lobed_casing(2, 2e-4, 1.5e-4), 900, 0.01,
                             {scheme, ContactRule::complementarity, 6000, 1});
    TimeMarch& march = bench.march;
    int in_contact = 0, several = 0;
    for (int i = 0; i < 20 * 6000; ++i) {
      march.step();
      const std::vector<int>& closed = march.contact().closed();
      ASSERT_GE(march.gap().minCoeff(), -1e-11 * 2e-4);
      ASSERT_GE(march.contact().multipliers().minCoeff(), 0.0);
      const auto leaves = [&](int index) {
        return std::any_of(march.impacts().begin(), march.impacts().end(),
                           [&](const InnerImpact& impact) { return impact.node() == index; });
      };
      for (int index : closed) ASSERT_TRUE(std::abs(march.gap()[index]) <= 1e-11 * 2e-4 || leaves(index));
      in_contact += closed.empty() ? 0 : 1;
      several += closed.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(in_contact, 10000);
    EXPECT_GT(several, 1000);
  }
}

TEST(TimeMarch, MovesNothingWithoutContact) {
  Bench bench = make_bench(testing::synthetic_wheel({}), testing::lobed_casing(2, 1e-4, 1.1e-4), 900, 0.01,
                           {Scheme::trigonometric, ContactRule::complementarity, 600, 1});
  for (int i = 0; i < 6000; ++i) bench.march.step();
  EXPECT_EQ(bench.march.displacement().cwiseAbs().maxCoeff(), 0.0);
}

/// A mass swings against a wall at rest, beyond its resting place. The impact is inelastic: the mass stops there, and
/// swings on from there with the distance of the wall as its amplitude.
TEST(TimeMarch, StopsAtAWallAtRestAndSwingsOnFromThere) {
  const double mass = 0.01, stiffness = 1e4, speed = 10, omega = 1000, wall = 4e-4, amplitude = 1e-3;
  for (Scheme scheme : {Scheme::trigonometric, Scheme::central_differences})
    for (int steps : {20000, 40000, 80000}) {
      Bench bench = make_bench(testing::one_mass(mass, stiffness), testing::lobed_casing(1, 0.0, wall), speed, 0.0,
                               {scheme, ContactRule::complementarity, steps, 1});
      const double h = bench.march.time_step();
      const Eigen::MatrixXd Y = bench.rotor.waves[0].normal_rows.real();
      const Eigen::VectorXd q = Y.transpose() / Y.squaredNorm() * -amplitude;
      bench.march.set_state(0, q.cast<std::complex<double>>(),
                            (q * (1 - std::cos(omega * h))).cast<std::complex<double>>());
      double farthest = 0;
      bool touched = false;
      for (int i = 0; i < 3 * pi / omega / h; ++i) {
        bench.march.step();
        touched |= !bench.march.contact().closed().empty();
        if (touched) farthest = std::max(farthest, -bench.march.displacement()[0]);
      }
      EXPECT_TRUE(touched);
      EXPECT_NEAR(farthest / wall, 1.0, 2 * omega * h);  // it is stopped in whole steps
    }
}

}  // namespace
}  // namespace tiprub::simulate::time_march_test
