// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/speed_polynomial.h"

#include <gtest/gtest.h>

#include "tests/reduce/dense_algebra.h"

namespace tiprub {
namespace {

using test::arbitrary;
using test::difference;

constexpr double top = 3000.0;  // [rad/s]

Eigen::MatrixXcd at(const SpeedPolynomial& Y, double speed) {
  return Y.Y0 + speed * speed * Y.Y1 + std::pow(speed, 4) * Y.Y2;
}

TEST(SpeedPolynomial, GoesThroughItsThreeSpeeds) {
  // Check 22. Arbitrary matrices that change as much as they are large.
  const Eigen::MatrixXcd all = arbitrary(4, 12);
  const Eigen::MatrixXcd rest = all.leftCols(4), half = all.middleCols(4, 4), full = all.rightCols(4);
  const SpeedPolynomial Y = SpeedPolynomial::through(rest, half, full, top);
  EXPECT_EQ(at(Y, 0.0), rest);
  EXPECT_LT(difference(at(Y, top / 2), half), 1e-12);
  EXPECT_LT(difference(at(Y, top), full), 1e-12);
}

TEST(SpeedPolynomial, FindsAPolynomialsOwnCoefficients) {
  const Eigen::MatrixXcd all = arbitrary(4, 12);
  const SpeedPolynomial exact{all.leftCols(4), all.middleCols(4, 4) / (top * top),
                              all.rightCols(4) / std::pow(top, 4)};
  const SpeedPolynomial Y = SpeedPolynomial::through(at(exact, 0.0), at(exact, top / 2), at(exact, top), top);
  EXPECT_LT(difference(Y.Y1, exact.Y1), 1e-13);
  EXPECT_LT(difference(Y.Y2, exact.Y2), 1e-13);
}

}  // namespace
}  // namespace tiprub
