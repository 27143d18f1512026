// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/craig_bampton.h"

#include <gtest/gtest.h>

#include "reduce/basis/cyclic_modes.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce::craig_bampton_test {
namespace {

using test::cyclic;
using test::difference;
using test::project;
using test::TestRotor;

constexpr int sectors = 5;
constexpr double top = 3000.0;  // [rad/s]

/// What one speed gives (eq. 8).
struct SpeedShapes {
  Eigen::MatrixXcd constraint_modes, fixed_interface_modes;
};

/// A rotor at rest and at full speed, and bases of any size for one nodal diameter.
class CraigBampton : public ::testing::TestWithParam<int> {
 protected:
  CraigBampton()
      : rotor_(test::tip_rotor(test::skewed_annulus(sectors))),
        wave_(rotor_.dofs(), sectors, GetParam()),
        mass_(rotor_.mass()),
        at_rest_(rotor_.at_rest()),
        at_top_(rotor_.at_speed(top, Prestress::linear)) {}

  SpeedShapes shapes(const SymmetricMatrix& stiffness, int modes) const {
    const SectorFactor factor(stiffness, rotor_.dofs());
    const CyclicSolver cyclic_stiffness(factor, wave_);
    return {cyclic_stiffness.constraint_modes(),
            lowest_modes(cyclic_stiffness, mass_, ContactNodes::fixed, modes, 1e-9).shape};
  }
  CraigBamptonBasis merge(const SpeedShapes& rest, const SpeedShapes& full) const {
    CraigBamptonBasis merged(wave_, mass_, {&at_rest_, &at_top_}, rest.constraint_modes);
    merged.append(rest.fixed_interface_modes);
    merged.append(full.fixed_interface_modes);
    merged.append(full.constraint_modes - rest.constraint_modes);
    merged.orthonormalise();
    return merged;
  }
  CraigBamptonBasis basis(int modes) const { return merge(shapes(at_rest_, modes), shapes(at_top_, modes)); }
  Eigen::MatrixXcd unreduced(const SymmetricMatrix& matrix) const {
    return cyclic(matrix, rotor_.dofs(), sectors, GetParam());
  }
  /// Worst relative errors of the lowest `count` eigenvalues of a basis at a speed.
  double worst_error(const CraigBamptonBasis& of, double speed, int count) {
    const SymmetricMatrix stiffness = rotor_.at_speed(speed, Prestress::linear);
    const Eigen::VectorXd exact = test::generalized_eigenvalues(unreduced(stiffness), unreduced(mass_));
    const Eigen::VectorXd ritz =
        test::generalized_eigenvalues(project(wave_, stiffness, of.shapes()), project(wave_, mass_, of.shapes()));
    double worst = 0;
    for (int k = 0; k < count; ++k) {
      EXPECT_GE(ritz[k], exact[k] * (1 - 1e-9)) << k;  // Rayleigh-Ritz: from above
      worst = std::max(worst, ritz[k] / exact[k] - 1);
    }
    return worst;
  }

  TestRotor rotor_;
  CyclicTransformation wave_;
  SymmetricMatrix mass_, at_rest_, at_top_;
};
INSTANTIATE_TEST_SUITE_P(NodalDiameter, CraigBampton, ::testing::Values(0, 1, 2));

TEST_P(CraigBampton, KeepsContactDofsPhysical) {
  // eq. 9: (I, Psi_s(0)) stands as it is, and Psi* has no contact rows.
  const Eigen::Index boundary = rotor_.dofs().boundary();
  const CraigBamptonBasis found = basis(4);
  EXPECT_EQ(found.shapes().leftCols(boundary), shapes(at_rest_, 4).constraint_modes);  // unchanged
  EXPECT_EQ(found.shapes().bottomLeftCorner(boundary, boundary), Eigen::MatrixXcd::Identity(boundary, boundary));
  EXPECT_EQ(found.shapes().bottomRows(boundary).rightCols(found.shapes().cols() - boundary).cwiseAbs().maxCoeff(),
            0.0);
}

TEST_P(CraigBampton, GeneralizedDofsAreOrthonormal) {
  // eq. 9: Psi*.
  const Eigen::MatrixXcd M = project(wave_, mass_, basis(4).shapes());
  const Eigen::Index size = M.cols() - rotor_.dofs().boundary();
  EXPECT_LT((M.bottomRightCorner(size, size) - Eigen::MatrixXcd::Identity(size, size)).cwiseAbs().maxCoeff(), 1e-10);
  const Eigen::MatrixXcd K = project(wave_, at_rest_, basis(4).shapes()).bottomRightCorner(size, size);
  const Eigen::VectorXd squares = K.diagonal().real();
  for (Eigen::Index k = 1; k < size; ++k) EXPECT_LE(squares[k - 1], squares[k] * (1 + 1e-9));
  EXPECT_LT((K - Eigen::MatrixXcd(squares.asDiagonal())).cwiseAbs().maxCoeff(), 1e-9 * squares.maxCoeff());
}

TEST_P(CraigBampton, ConstraintModesAtRestDoNotMeetTheGeneralizedDofsInStiffness) {
  // Psi' K phi = 0 at rest: the one coupling a Craig-Bampton model has is in its mass.
  const Eigen::MatrixXcd K = project(wave_, at_rest_, basis(4).shapes());
  const Eigen::Index boundary = rotor_.dofs().boundary(), size = K.cols() - boundary;
  const Eigen::VectorXd scale = K.diagonal().real().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXcd scaled = scale.asDiagonal() * K * scale.asDiagonal();
  EXPECT_LT(scaled.topRightCorner(boundary, size).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_P(CraigBampton, KnowsWhatTheSectorsMatricesMakeOfIt) {
  // eq. 10
  const CraigBamptonBasis found = basis(4);
  EXPECT_LT(difference(found.stiffness(0), project(wave_, at_rest_, found.shapes())), 1e-10);
  EXPECT_LT(difference(found.stiffness(1), project(wave_, at_top_, found.shapes())), 1e-10);
  EXPECT_LT(difference(found.mass(), project(wave_, mass_, found.shapes())), 1e-10);
  const Eigen::MatrixXcd some = test::arbitrary(found.size(), 3);
  const Eigen::MatrixXcd moved = found.combine(some);
  EXPECT_LT(difference(moved, found.shapes() * some), 1e-12);
  EXPECT_LT(difference(found.inner_products(moved), found.shapes().adjoint() * moved), 1e-12);
}

TEST_P(CraigBampton, ProjectionsAreHermitianAndTheMassIsPositive) {
  const CraigBamptonBasis found = basis(4);
  for (const SymmetricMatrix* matrix : {&at_rest_, &at_top_, &mass_}) {
    const Eigen::MatrixXcd reduced = project(wave_, *matrix, found.shapes());
    EXPECT_EQ(reduced, reduced.adjoint());
    EXPECT_LT(difference(reduced, found.shapes().adjoint() * unreduced(*matrix) * found.shapes()), 1e-12);
    EXPECT_EQ(reduced.imag().cwiseAbs().maxCoeff() == 0.0, wave_.is_real());
  }
  EXPECT_TRUE(test::is_positive_definite(project(wave_, mass_, found.shapes())));
}

TEST_P(CraigBampton, FollowsContactLoadsExactlyWithOneMode) {
  // The limit of Guyan (1965): statics of the contact dofs need no mode, at rest and at the other speed of the basis.
  const CraigBamptonBasis found = basis(1);
  const Eigen::Index boundary = rotor_.dofs().boundary();
  const Eigen::MatrixXcd load = test::arbitrary(boundary, 2);
  for (const SymmetricMatrix* matrix : {&at_rest_, &at_top_}) {
    Eigen::MatrixXcd full = Eigen::MatrixXcd::Zero(rotor_.dofs().independent(), 2);
    full.bottomRows(boundary) = load;
    const Eigen::MatrixXcd exact = test::solved(unreduced(*matrix), full).bottomRows(boundary);
    const Eigen::MatrixXcd K = project(wave_, *matrix, found.shapes());
    Eigen::MatrixXcd reduced = Eigen::MatrixXcd::Zero(K.rows(), 2);
    reduced.topRows(boundary) = load;
    EXPECT_LT(difference(test::solved(K, reduced).topRows(boundary), exact), 1e-8);
  }
}

TEST_P(CraigBampton, ErrsLessWithMoreModes) {
  // Also at a speed that the basis never saw.
  for (const double speed : {0.0, 0.6 * top, top}) {
    double before = 1e300;
    for (const int modes : {2, 8, 20}) {
      const double error = worst_error(basis(modes), speed, 5);
      EXPECT_LT(error, 0.5 * before) << modes << " modes at " << speed;
      before = error;
    }
    EXPECT_LT(before, 5e-3);
  }
}

TEST_P(CraigBampton, IsExactWithAllModes) {
  const int all = rotor_.dofs().independent() - rotor_.dofs().boundary();
  const CraigBamptonBasis found = basis(all);
  EXPECT_EQ(found.shapes().cols(), rotor_.dofs().independent());
  for (const double speed : {0.0, 0.6 * top}) EXPECT_LT(worst_error(found, speed, all), 1e-7);
}

TEST_P(CraigBampton, CountsWhatItDrops) {
  // Everything there is from rest; all that full speed adds is known already.
  const int boundary = rotor_.dofs().boundary(), all = rotor_.dofs().independent() - boundary;
  const CraigBamptonBasis found = basis(all);
  EXPECT_EQ(found.dropped(), all + boundary);
  EXPECT_EQ(basis(2).dropped(), 0);
}

TEST_P(CraigBampton, ASpeedThatChangesNothingAddsNothing) {
  // A model for rest alone (a speed_max near zero) crashed: constraint modes that don't change with speed are zero
  // columns, which were divided by their length. They must be dropped and counted.
  const SpeedShapes rest = shapes(at_rest_, 3);
  const CraigBamptonBasis found = merge(rest, rest);
  EXPECT_EQ(found.dropped(), 3 + rotor_.dofs().boundary());
  EXPECT_EQ(found.shapes().cols(), 3 + rotor_.dofs().boundary());
  EXPECT_TRUE(found.shapes().allFinite());
}

}  // namespace
}  // namespace tiprub::reduce::craig_bampton_test
