// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reduce/operators/speed_samples.h"
#include "tests/reduce/dense_algebra.h"

namespace tiprub::reduce {
namespace {

using test::arbitrary;
using test::difference;

constexpr double top = 3000.0;  // [rad/s]

using Polynomial = SpeedPolynomial<Eigen::MatrixXcd, 0>;

/// Arbitrary matrices that change as much as they are large.
std::vector<Eigen::MatrixXcd> some_matrices(int count) {
  const Eigen::MatrixXcd all = arbitrary(4, 4 * count);
  std::vector<Eigen::MatrixXcd> matrices;
  for (int k = 0; k < count; ++k) matrices.push_back(all.middleCols(4 * k, 4));
  return matrices;
}

TEST(PolynomialFit, GoesThroughItsSpeeds) {
  // eq. 7 (check 22).
  for (const std::vector<double>& speeds :
       {std::vector{0.0, top / 2, top}, {0.0, top / 4, top / 2, 0.75 * top, top}}) {
    const std::vector<Eigen::MatrixXcd> samples = some_matrices(static_cast<int>(speeds.size()));
    const Polynomial Y = PolynomialFit(speeds).through(samples);
    ASSERT_EQ(Y.terms.size(), speeds.size());
    EXPECT_EQ(Y(0.0), samples[0]);
    for (std::size_t s = 1; s < speeds.size(); ++s) EXPECT_LT(difference(Y(speeds[s]), samples[s]), 1e-12);
  }
}

TEST(PolynomialFit, FindsAPolynomialsOwnCoefficients) {
  Polynomial exact{some_matrices(3)};
  exact[1] /= top * top;
  exact[2] /= std::pow(top, 4);
  const std::vector<double> speeds = {0.0, top / 2, top};
  const Polynomial Y = PolynomialFit(speeds).through(std::vector{exact(0.0), exact(top / 2), exact(top)});
  for (int k = 0; k < 3; ++k) EXPECT_LT(difference(Y[k], exact[k]), 1e-13);
}

TEST(PolynomialFit, WeighsItsSamplesAsItsCoefficientsDo) {
  const std::vector<double> speeds = {0.0, top / 4, top / 2, 0.75 * top, top};
  const PolynomialFit fit(speeds);
  const std::vector<Eigen::MatrixXcd> samples = some_matrices(5);
  const Polynomial Y = fit.through(samples);
  for (const double speed : {0.0, 0.3 * top, 0.9 * top, top}) {
    const Eigen::VectorXd weights = fit.weights(speed);
    Eigen::MatrixXcd sum = weights[0] * samples[0];
    for (int s = 1; s < 5; ++s) sum += weights[s] * samples[s];
    EXPECT_LT(difference(sum, Y(speed)), 1e-12);
  }
}

/// The inverse of 17 terms alone left 2e-5.
TEST(PolynomialFit, LosesNoDigitsWithManyTerms) {
  const Eigen::MatrixXcd matrix = arbitrary(4, 4);
  const auto exact = [&](double speed) -> Eigen::MatrixXcd { return matrix / (1 + 3 * std::pow(speed / top, 2)); };
  const std::vector<double> speeds = speeds_at(chebyshev_fractions(16), top);
  std::vector<Eigen::MatrixXcd> samples;
  for (const double speed : speeds) samples.push_back(exact(speed));
  const PolynomialFit fit(speeds);
  const Polynomial Y = fit.through(samples);
  for (const double speed : speeds) EXPECT_LT(difference(Y(speed), exact(speed)), 1e-11);
  for (const double speed : {0.03 * top, 0.4 * top, 0.77 * top, 0.99 * top}) {
    EXPECT_LT(difference(Y(speed), exact(speed)), 1e-7);  // Chebyshev's series ends there: 3^-16
    EXPECT_NEAR(fit.weights(speed).sum(), 1.0, 1e-11);
  }
}

TEST(SpeedSamples, AreThePapersForOneTermAndKeepEquilibriaApart) {
  ReductionParameters p;
  p.verification_speeds = {0.0, 0.5, 0.7, 1.0};
  EXPECT_EQ(SpeedSamples(p, 1).fractions(), (std::vector{0.0, 0.5, 1.0}));
  p.prestress = Prestress::nonlinear;
  const SpeedSamples samples(p, 1);
  EXPECT_EQ(samples.fractions(), (std::vector{0.0, 0.5, 1.0, 0.5, 0.7}));
  EXPECT_EQ(samples.polynomial_terms(), 3);
  EXPECT_EQ(samples.weights(0.5), Eigen::VectorXd::Unit(5, 3));  // the equilibrium, not the polynomial's shape
  EXPECT_EQ(samples.weights(1.0), Eigen::VectorXd::Unit(5, 2));
  EXPECT_EQ(samples.weights(0.6).tail(2), Eigen::VectorXd::Zero(2));
  EXPECT_EQ(SpeedSamples(p, 2).fractions().size(), 5u + 2u);
}

}  // namespace
}  // namespace tiprub::reduce
