// SPDX-License-Identifier: GPL-3.0-or-later
// Why the cyclic transformation is ours: deal.II can hold the phase between the cut faces in its own constraints, and
// finds the same frequencies. Each nodal diameter then has a matrix, and a factor, of its own, of twice the size.
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <gtest/gtest.h>

#include <complex>
#include <numbers>
#include <numeric>

#include "reduce/basis/cyclic_modes.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using Complex = std::complex<double>;
using Dof = dealii::types::global_dof_index;

constexpr int sectors = 6;

/// u_high = e^{i n alpha} u_low.
Complex phase_of(int n) {
  return std::polar(1.0, 2 * std::numbers::pi * n / sectors);
}

/// The phase in real numbers: the first half of the dofs are real parts, the second half imaginary ones.
dealii::AffineConstraints<double> constraints_of_parts(const SectorDofs& dofs, Complex phase) {
  dealii::AffineConstraints<double> constraints;
  const auto imaginary = static_cast<Dof>(dofs.sector());
  for (int k = 0; k < dofs.face; ++k) {
    const auto low = static_cast<Dof>(dofs.interior + k), high = low + static_cast<Dof>(dofs.face);
    constraints.add_line(high);
    constraints.add_entries(high, {{low, phase.real()}, {low + imaginary, -phase.imag()}});
    constraints.add_line(high + imaginary);
    constraints.add_entries(high + imaginary, {{low, phase.imag()}, {low + imaginary, phase.real()}});
  }
  constraints.close();
  return constraints;
}

dealii::AffineConstraints<Complex> complex_constraints(const SectorDofs& dofs, Complex phase) {
  dealii::AffineConstraints<Complex> constraints;
  for (int k = 0; k < dofs.face; ++k) {
    const auto low = static_cast<Dof>(dofs.interior + k);
    constraints.add_line(low + static_cast<Dof>(dofs.face));
    constraints.add_entry(low + static_cast<Dof>(dofs.face), low, phase);
  }
  constraints.close();
  return constraints;
}

/// The matrix of the dofs that are free, by deal.II.
template <class Number>
Eigen::MatrixXcd constrained(const Eigen::MatrixXd& matrix, const dealii::AffineConstraints<Number>& constraints) {
  const auto size = static_cast<Dof>(matrix.rows());
  std::vector<Dof> all(size), free;
  std::iota(all.begin(), all.end(), Dof{0});
  dealii::FullMatrix<Number> local(size, size);
  for (const Dof i : all)
    for (const Dof j : all) local(i, j) = matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  dealii::DynamicSparsityPattern entries(size, size);
  constraints.add_entries_local_to_global(all, entries);
  dealii::SparsityPattern pattern;
  pattern.copy_from(entries);
  dealii::SparseMatrix<Number> global(pattern);
  constraints.distribute_local_to_global(local, all, global);
  for (const Dof i : all)
    if (!constraints.is_constrained(i)) free.push_back(i);
  return Eigen::MatrixXcd::NullaryExpr(static_cast<Eigen::Index>(free.size()), static_cast<Eigen::Index>(free.size()),
                                       [&](Eigen::Index i, Eigen::Index j) { return global.el(free[i], free[j]); });
}

/// Y of the real parts and of the imaginary ones.
Eigen::MatrixXd doubled(const Eigen::MatrixXd& matrix) {
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * matrix.rows(), 2 * matrix.cols());
  both.topLeftCorner(matrix.rows(), matrix.cols()) = matrix;
  both.bottomRightCorner(matrix.rows(), matrix.cols()) = matrix;
  return both;
}

class PhaseConstraints : public ::testing::Test {
 protected:
  PhaseConstraints()
      : rotor_(test::tip_rotor(test::skewed_annulus(sectors))),
        mass_(rotor_.mass()),
        stiffness_(rotor_.at_speed(2000.0, Prestress::linear)) {}

  test::TestRotor rotor_;
  SymmetricMatrix mass_, stiffness_;
};

TEST_F(PhaseConstraints, OfTheDoubledSystemGiveTheSameFrequenciesTwice) {
  const SectorFactor factor(stiffness_, rotor_.dofs());  // one, for all nodal diameters
  constexpr int count = 12;
  for (int n = 0; n <= sectors / 2; ++n) {
    const CyclicModes ours =
        lowest_modes(CyclicSolver(factor, {rotor_.dofs(), sectors, n}), mass_, ContactNodes::free, count, 1e-9);
    const auto constraints = constraints_of_parts(rotor_.dofs(), phase_of(n));
    const Eigen::VectorXd theirs =
        test::generalized_eigenvalues(constrained(doubled(test::dense(stiffness_)), constraints),
                                      constrained(doubled(test::dense(mass_)), constraints));
    for (int k = 0; k < 2 * count; ++k) EXPECT_NEAR(theirs[k] / ours.eigenvalue[k / 2], 1.0, 1e-9) << n << " " << k;
  }
}

// Constraints between complex dofs are resolved with the plain transpose of T, where a Hermitian matrix needs T^H.
TEST_F(PhaseConstraints, OfComplexDofsLeaveNoHermitianMatrix) {
  const Eigen::MatrixXd K = test::dense(stiffness_);
  for (const int n : {1, 2}) {
    const Eigen::MatrixXcd theirs = constrained(K, complex_constraints(rotor_.dofs(), phase_of(n)));
    const Eigen::MatrixXcd ours = test::cyclic(stiffness_, rotor_.dofs(), sectors, n);
    EXPECT_LT(test::difference(ours.adjoint(), ours), 1e-12);
    EXPECT_GT(test::difference(theirs.adjoint(), theirs), 0.1);
    const Eigen::MatrixXcd T = test::phase_matrix(rotor_.dofs(), sectors, n);
    EXPECT_LT(test::difference(theirs, T.transpose() * K * T), 1e-12);
  }
}

}  // namespace
}  // namespace tiprub::reduce
