// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/cyclic_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cases/complaint.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::arbitrary;
using test::cyclic;
using test::difference;
using test::TestRotor;

/// Of an even and an odd number of sectors, a spinning rotor: K of one speed, one factor.
class EverySectorCount : public ::testing::TestWithParam<int> {
 protected:
  EverySectorCount()
      : rotor_(test::tip_rotor(test::skewed_annulus(GetParam()))),
        stiffness_(rotor_.at_speed(2000.0, Prestress::linear)),
        factor_(stiffness_, rotor_.dofs()) {}

  CyclicTransformation wave(int n) const { return {rotor_.dofs(), GetParam(), n}; }
  Eigen::MatrixXcd K(int n) const { return cyclic(stiffness_, rotor_.dofs(), GetParam(), n); }
  int last() const { return GetParam() / 2; }
  /// Three columns that a wave of n nodal diameters can have: real ones if it stands.
  Eigen::MatrixXcd columns(int n, Eigen::Index rows) const {
    const Eigen::MatrixXcd any = arbitrary(rows, 3);
    return wave(n).is_real() ? Eigen::MatrixXcd(any.real().cast<std::complex<double>>()) : any;
  }

  TestRotor rotor_;
  SymmetricMatrix stiffness_;
  SectorFactor factor_;
};
INSTANTIATE_TEST_SUITE_P(Sectors, EverySectorCount, ::testing::Values(3, 4, 5, 6));

TEST_P(EverySectorCount, WavesExpandAndGatherByThePhase) {
  // eq. 6 as T^H Y T.
  for (int n = 0; n <= last(); ++n) {
    const Eigen::MatrixXcd T = test::phase_matrix(rotor_.dofs(), GetParam(), n);
    const Eigen::MatrixXcd x = columns(n, T.cols()), f = columns(n, T.rows());
    EXPECT_LT(difference(wave(n).expand(x), T * x), 1e-14);
    EXPECT_LT(difference(wave(n).gather(f), T.adjoint() * f), 1e-14);
    EXPECT_LT(difference(wave(n).apply(stiffness_, x), K(n) * x), 1e-13);
  }
}

TEST_P(EverySectorCount, StandsOnlyForZeroAndHalfTheSectors) {
  for (int n = 0; n <= last(); ++n) {
    EXPECT_EQ(wave(n).is_real(), n == 0 || 2 * n == GetParam());
    if (!wave(n).is_real()) continue;
    const Eigen::MatrixXcd real = arbitrary(rotor_.dofs().independent(), 2).real();
    EXPECT_EQ(wave(n).apply(stiffness_, real).imag().cwiseAbs().maxCoeff(), 0.0);
  }
}

TEST_P(EverySectorCount, OneFactorSolvesForAllNodalDiameters) {
  for (int n = 0; n <= last(); ++n) {
    const CyclicSolver cyclic_stiffness(factor_, wave(n));
    const Eigen::MatrixXcd b = columns(n, rotor_.dofs().independent());
    const Eigen::MatrixXcd x = cyclic_stiffness.solve(b, ContactNodes::free);
    EXPECT_LT(difference(K(n) * x, b), 1e-10) << n;
    EXPECT_LT(difference(x, test::solved(K(n), b)), 1e-10) << n;
  }
}

TEST_P(EverySectorCount, HeldContactNodesStayAndTheOthersAreInBalance) {
  const Eigen::Index inner = rotor_.dofs().interior + rotor_.dofs().face;
  for (int n = 0; n <= last(); ++n) {
    const CyclicSolver cyclic_stiffness(factor_, wave(n));
    Eigen::MatrixXcd b = columns(n, rotor_.dofs().independent());
    const Eigen::MatrixXcd x = cyclic_stiffness.solve(b, ContactNodes::fixed);
    EXPECT_EQ(x.bottomRows(rotor_.dofs().boundary()).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_LT(difference((K(n) * x).topRows(inner), b.topRows(inner)), 1e-10) << n;
    b.bottomRows(rotor_.dofs().boundary()) *= 5.0;  // their load is of no account
    EXPECT_EQ(cyclic_stiffness.solve(b, ContactNodes::fixed), x);
  }
}

TEST_P(EverySectorCount, ConstraintModesHaveUnitRowsAndNoInnerForce) {
  // eq. 8: (I, Psi_s).
  const Eigen::Index boundary = rotor_.dofs().boundary(), inner = rotor_.dofs().interior + rotor_.dofs().face;
  for (int n = 0; n <= last(); ++n) {
    const Eigen::MatrixXcd psi = CyclicSolver(factor_, wave(n)).constraint_modes();
    EXPECT_EQ(psi.bottomRows(boundary), Eigen::MatrixXcd::Identity(boundary, boundary));
    const Eigen::MatrixXcd force = K(n) * psi;
    EXPECT_LT(force.topRows(inner).cwiseAbs().maxCoeff(), 1e-11 * force.cwiseAbs().maxCoeff()) << n;
    EXPECT_EQ(psi.imag().cwiseAbs().maxCoeff() == 0.0, wave(n).is_real());
  }
}

TEST(CyclicSolver, RefusesARotorThatOnlyOneNodalDiameterMakesUnstable) {
  // A speed at which the sector's interior still stands and the wheel does not: bisect between both by dense algebra.
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(5));
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, rotor.mesh().node_count());
  const Eigen::VectorXd rest = test::generalized_eigenvalues(cyclic(rotor.at_rest(), rotor.dofs(), 5, 0),
                                                             cyclic(rotor.mass(), rotor.dofs(), 5, 0));
  // Without stress stiffening, K - Omega^2 M_perp is indefinite once Omega^2 exceeds the lowest in-plane eigenvalue.
  double speed = std::sqrt(rest[0]);
  std::string message;
  while (message.empty()) {
    speed *= 1.05;
    const SectorFactor factor(rotor.elasticity().stiffness(speed, still, Prestress::linear), rotor.dofs());
    message = complaint<RunError>([&] {
      for (int n = 0; n <= 2; ++n) CyclicSolver(factor, CyclicTransformation(rotor.dofs(), 5, n)).constraint_modes();
    });
    bool indefinite = false;
    for (int n = 0; n <= 2; ++n) {
      const SymmetricMatrix K = rotor.elasticity().stiffness(speed, still, Prestress::linear);
      indefinite |= !test::is_positive_definite(cyclic(K, rotor.dofs(), 5, n));
    }
    EXPECT_EQ(indefinite, !message.empty()) << speed;
  }
  EXPECT_EQ(message, "the stiffness of a nodal diameter is not positive definite: the rotor is unstable");
}

}  // namespace
}  // namespace tiprub::reduce
