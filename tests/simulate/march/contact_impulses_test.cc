// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/contact_impulses.h"

#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Cholesky>
#include <random>

#include "simulate/motion/attempt.h"

namespace tiprub::simulate {
namespace {

class Random {
 public:
  double operator()() { return 2.0 * source_() / std::mt19937::max() - 1.0; }

 private:
  std::mt19937 source_{11};
};

Eigen::MatrixXd positive_definite(Random& random, Eigen::Index size, double floor) {
  const Eigen::MatrixXd factor = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return random(); });
  return factor * factor.transpose() + floor * Eigen::MatrixXd::Identity(size, size);
}

Eigen::VectorXd with_a_penetration(Random& random, Eigen::Index size) {
  Eigen::VectorXd gap = Eigen::VectorXd::NullaryExpr(size, [&] { return random(); });
  gap[0] = -std::abs(gap[0]);
  return gap;
}

/// Tries every set of closed nodes.
Eigen::VectorXd by_brute_force(const Eigen::MatrixXd& W, const Eigen::VectorXd& gap) {
  for (unsigned set = 1; set < 1u << gap.size(); ++set) {
    std::vector<Eigen::Index> closed;
    for (Eigen::Index i = 0; i < gap.size(); ++i)
      if ((set >> i & 1u) != 0) closed.push_back(i);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(gap.size());
    forces(closed) = W(closed, closed).llt().solve(Eigen::VectorXd(-gap(closed))).eval();
    if (forces.minCoeff() >= 0 && (gap + W * forces).minCoeff() > -1e-12) return forces;
  }
  return {};
}

void expect_complementary(const Eigen::MatrixXd& W, const Eigen::VectorXd& free_gap, const ContactImpulses& contact,
                          const Eigen::VectorXd& gap) {
  // what the forces move the nodes by, one by one: the solver's shift is relative to that
  const double scale = free_gap.cwiseAbs().maxCoeff() + W.diagonal().cwiseProduct(contact.multipliers()).maxCoeff();
  EXPECT_GE(contact.multipliers().minCoeff(), 0.0);
  EXPECT_GE(gap.minCoeff(), -1e-11 * scale);
  EXPECT_LE(contact.multipliers().cwiseProduct(gap).cwiseAbs().maxCoeff(),
            1e-11 * scale * contact.multipliers().maxCoeff());
  EXPECT_LE((gap - free_gap - W * contact.multipliers()).cwiseAbs().maxCoeff(), 1e-13 * scale);
}

TEST(Complementarity, AgreesWithBruteForce) {
  Random random;
  for (int problem = 0; problem < 300; ++problem) {
    const Eigen::Index size = 1 + problem % 7;
    const Eigen::MatrixXd W = positive_definite(random, size, 0.1);
    ContactImpulses contact(W, ContactRule::complementarity);
    for (int step = 0; step < 3; ++step) {  // the second and third start from the last set
      const Eigen::VectorXd free_gap = with_a_penetration(random, size);
      Eigen::VectorXd gap = free_gap;
      contact.solve(gap);
      expect_complementary(W, free_gap, contact, gap);
      const Eigen::VectorXd expected = by_brute_force(W, free_gap);
      ASSERT_EQ(expected.size(), size);
      EXPECT_LE((contact.multipliers() - expected).norm(), 1e-9 * (1 + expected.norm()));
    }
  }
}

/// Two nodes in one place have one displacement: W is singular, forces aren't unique, displacements are.
TEST(Complementarity, StandsDoubledNodes) {
  Random random;
  for (int problem = 0; problem < 100; ++problem) {
    const Eigen::MatrixXd single = positive_definite(random, 3, 0.1);
    const std::vector<int> twice = {0, 0, 1, 1, 2};
    const Eigen::MatrixXd W = single(twice, twice);
    Eigen::VectorXd free_gap = with_a_penetration(random, 5);
    if (problem % 2 == 0) free_gap[1] = free_gap[0];  // the same clearance too
    Eigen::VectorXd gap = free_gap;
    ContactImpulses contact(W, ContactRule::complementarity);
    contact.solve(gap);
    expect_complementary(W, free_gap, contact, gap);
    // one node with the smaller of both gaps moves alike
    Eigen::VectorXd tighter(3);
    tighter << std::min(free_gap[0], free_gap[1]), std::min(free_gap[2], free_gap[3]), free_gap[4];
    const Eigen::VectorXd expected = single * by_brute_force(single, tighter);
    EXPECT_LE((contact.correction()(std::vector<int>{0, 2, 4}) - expected).norm(), 1e-9);
  }
}

/// A symmetric positive definite problem in which the active set runs in a circle from the penetrating nodes.
TEST(Complementarity, FallsBackWhereTheActiveSetCircles) {
  Eigen::Matrix3d W;
  W << 2.8412, -0.7332, 2.3595, -0.7332, 1.5767, -1.0401, 2.3595, -1.0401, 2.1349;
  const Eigen::Vector3d free_gap(-0.0973, 1.3759, -0.8527);
  Eigen::VectorXd gap = free_gap;
  ContactImpulses contact(W, ContactRule::complementarity);
  contact.solve(gap);
  EXPECT_EQ(contact.fallbacks(), 1);
  expect_complementary(W, free_gap, contact, gap);
}

/// Sets that come and go are solved with the inverse that is kept, to rounding; a doubled node makes it useless, and
/// the block is factorized.
TEST(Complementarity, FactorizesOnlyWhereTheInverseIsNone) {
  constexpr Eigen::Index size = 12;
  Random random;
  Eigen::MatrixXd W = positive_definite(random, size, 1.0);
  const auto rub = [&](ContactImpulses& contact) {
    for (int step = 0; step < 500; ++step) {
      Eigen::VectorXd free_gap(size);
      for (Eigen::Index i = 0; i < size; ++i) free_gap[i] = std::sin(0.7 * static_cast<double>(i) + 0.31 * step);
      Eigen::VectorXd gap = free_gap;
      contact.solve(gap);
      expect_complementary(W, free_gap, contact, gap);
    }
  };
  ContactImpulses regular(W, ContactRule::complementarity);
  rub(regular);
  EXPECT_EQ(regular.factorizations(), 0);
  W.row(1) = W.row(0);
  W.col(1) = W.col(0);
  ContactImpulses doubled(W, ContactRule::complementarity);
  Eigen::VectorXd gap = Eigen::VectorXd::Constant(size, 1.0);
  gap[0] = gap[1] = -1;
  doubled.solve(gap);
  EXPECT_GT(doubled.factorizations(), 0);
  EXPECT_GT(gap.minCoeff(), -1e-10);
}

TEST(Complementarity, RefusesAComplianceThatIsNone) {
  Eigen::Matrix2d W;
  W << -1, 0, 0, 1;
  ContactImpulses contact(W, ContactRule::complementarity);
  Eigen::VectorXd gap = Eigen::Vector2d(-1, -1);
  EXPECT_THROW(contact.solve(gap), NoMotion);
}

/// eq. 14, eq. 15. Two stiffly tied nodes, one of them deep: the equality pulls the other one back to the wall.
TEST(PapersRule, ClosesEveryPenetratingNodeAndMayPull) {
  Eigen::Matrix2d W;
  W << 1.0, 0.9, 0.9, 1.0;
  ContactImpulses contact(W, ContactRule::paper);
  Eigen::VectorXd gap = Eigen::Vector2d(-1.0, -0.1);
  contact.solve(gap);
  EXPECT_NEAR(gap.cwiseAbs().maxCoeff(), 0.0, 1e-11);
  EXPECT_LT(contact.multipliers()[1], 0);
}

TEST(PapersRule, LeavesANodeThatItPushedThrough) {
  Eigen::Matrix2d W;
  W << 1.0, -0.9, -0.9, 1.0;
  ContactImpulses contact(W, ContactRule::paper);
  Eigen::VectorXd gap = Eigen::Vector2d(-1.0, 0.1);
  contact.solve(gap);
  EXPECT_NEAR(gap[0], 0.0, 1e-11);
  EXPECT_LT(gap[1], -0.5);
}

}  // namespace
}  // namespace tiprub::simulate
