// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/spinning_sector.h"

#include <gtest/gtest.h>

#include "reduce/operators/speed_samples.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::spin_shape_test {
namespace {

using test::dense;
using test::TestRotor;

constexpr double top = 3000.0;  // [rad/s]
constexpr int sectors = 5;

ReductionParameters parameters() {
  ReductionParameters p;
  p.material = test::steel();
  p.material.young /= 10;  // so that the shape changes visibly
  p.prestress = Prestress::nonlinear;
  p.speed_max = top;
  p.verification_speeds = {0.0, 0.6};
  p.polynomial_tolerance = 1e-4;
  return p;
}

/// A rotor with what its shape needs.
class SpinningShape : public ::testing::Test {
 protected:
  SpinningShape()
      : rotor_(test::tip_rotor(test::skewed_annulus(sectors), parameters().material)),
        factor_(rotor_.at_rest(), rotor_.dofs()),
        at_rest_(factor_, CyclicTransformation(rotor_.dofs(), sectors, 0)) {}
  SpinShape shape(const ReductionParameters& p) {
    return spin_shape({rotor_.elasticity(), rotor_.mesh(), at_rest_}, p);
  }
  Eigen::MatrixXd tangent(const SpinShape& shape, double speed) {
    return dense(rotor_.elasticity().stiffness(
        speed, cartesian_displacement(rotor_.mesh(), rotor_.dofs(), shape.displacement(speed)),
        Prestress::nonlinear));
  }

  TestRotor rotor_;
  SectorFactor factor_;
  CyclicSolver at_rest_;
};

TEST_F(SpinningShape, HasATangentOfTwiceItsTermsAndOne) {
  // eq. 7 of more terms, exactly
  ReductionParameters p = parameters();
  for (const int terms : {1, 2, 4}) {
    p.polynomial_speeds = terms + 1;
    const SpinShape found = shape(p);
    ASSERT_EQ(found.displacement.terms.size(), static_cast<std::size_t>(terms));
    const std::vector<double> speeds = speeds_at(chebyshev_fractions(2 * terms), top);
    const Eigen::VectorXd weights = PolynomialFit(speeds).weights(0.37 * top);
    Eigen::MatrixXd sum = 0 * tangent(found, 0.0);
    for (std::size_t s = 0; s < speeds.size(); ++s)
      sum += weights[static_cast<Eigen::Index>(s)] * tangent(found, speeds[s]);
    const Eigen::MatrixXd exact = tangent(found, 0.37 * top);
    EXPECT_LT((sum - exact).norm(), 1e-11 * exact.norm()) << terms;
  }
}

TEST_F(SpinningShape, IsInBalanceBetweenItsSpeeds) {
  const SpinShape found = shape(parameters());
  EXPECT_GT(found.displacement.terms.size(), 1u);
  EXPECT_LE(found.imbalance, 1e-4);
  for (const double fraction : {0.1, 0.33, 0.52, 0.78, 0.97})
    EXPECT_LT(spin_imbalance({rotor_.elasticity(), rotor_.mesh(), at_rest_}, fraction * top,
                             found.displacement(fraction * top)),
              2e-4)
        << fraction;
  EXPECT_LT((found.displacement(top) - found.equilibria.at.at(top)).norm(), 1e-12 * found.displacement(top).norm());
}

TEST_F(SpinningShape, GoesWithTheSquareOfSpeedIfItIsLinear) {
  ReductionParameters p = parameters();
  p.prestress = Prestress::linear;
  const SpinShape found = shape(p);
  ASSERT_EQ(found.displacement.terms.size(), 1u);
  const Eigen::Matrix3Xd exact = rotor_.static_displacement(0.4 * top);
  EXPECT_LT((cartesian_displacement(rotor_.mesh(), rotor_.dofs(), found.displacement(0.4 * top)) - exact).norm(),
            1e-9 * exact.norm());
}

}  // namespace
}  // namespace tiprub::reduce::spin_shape_test
