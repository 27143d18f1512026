// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/speed_polynomial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/reduce/dense_algebra.h"

namespace tiprub {
namespace {

using test::arbitrary;
using test::difference;

constexpr double top = 3000.0;  // [rad/s]

Eigen::MatrixXcd at(const std::vector<Eigen::MatrixXcd>& terms, double speed) {
  Eigen::MatrixXcd sum = terms[0];
  for (std::size_t k = 1; k < terms.size(); ++k) sum += std::pow(speed, 2.0 * static_cast<double>(k)) * terms[k];
  return sum;
}

/// Arbitrary matrices that change as much as they are large.
std::vector<Eigen::MatrixXcd> some_matrices(int count) {
  const Eigen::MatrixXcd all = arbitrary(4, 4 * count);
  std::vector<Eigen::MatrixXcd> matrices;
  for (int k = 0; k < count; ++k) matrices.push_back(all.middleCols(4 * k, 4));
  return matrices;
}

TEST(SpeedPolynomial, GoesThroughItsSpeeds) {
  // eq. 7 (check 22).
  for (const std::vector<double>& speeds :
       {std::vector{0.0, top / 2, top}, {0.0, top / 4, top / 2, 0.75 * top, top}}) {
    const std::vector<Eigen::MatrixXcd> samples = some_matrices(static_cast<int>(speeds.size()));
    const std::vector<Eigen::MatrixXcd> terms = SpeedPolynomial(speeds).coefficients(samples);
    ASSERT_EQ(terms.size(), speeds.size());
    EXPECT_EQ(at(terms, 0.0), samples[0]);
    for (std::size_t s = 1; s < speeds.size(); ++s) EXPECT_LT(difference(at(terms, speeds[s]), samples[s]), 1e-12);
  }
}

TEST(SpeedPolynomial, FindsAPolynomialsOwnCoefficients) {
  std::vector<Eigen::MatrixXcd> exact = some_matrices(3);
  exact[1] /= top * top;
  exact[2] /= std::pow(top, 4);
  const std::vector<double> speeds = {0.0, top / 2, top};
  const std::vector<Eigen::MatrixXcd> terms =
      SpeedPolynomial(speeds).coefficients({at(exact, 0.0), at(exact, top / 2), at(exact, top)});
  for (int k = 0; k < 3; ++k) EXPECT_LT(difference(terms[k], exact[k]), 1e-13);
}

TEST(SpeedPolynomial, WeighsItsSamplesAsItsCoefficientsDo) {
  const std::vector<double> speeds = {0.0, top / 4, top / 2, 0.75 * top, top};
  const SpeedPolynomial Y(speeds);
  const std::vector<Eigen::MatrixXcd> samples = some_matrices(5), terms = Y.coefficients(samples);
  for (const double speed : {0.0, 0.3 * top, 0.9 * top, top}) {
    const Eigen::VectorXd weights = Y.weights(speed);
    Eigen::MatrixXcd sum = weights[0] * samples[0];
    for (int s = 1; s < 5; ++s) sum += weights[s] * samples[s];
    EXPECT_LT(difference(sum, at(terms, speed)), 1e-12);
  }
}

}  // namespace
}  // namespace tiprub
