// SPDX-License-Identifier: GPL-3.0-or-later
// The block eigensolver against another one: Anasazi's block Krylov-Schur (Baker, Hetmaniuk, Lehoucq, Thornquist
// 2009) on K^-1 M of the doubled real problem,
//     [Re K  -Im K; Im K  Re K] (Re x; Im x) = lambda [Re M  -Im M; Im M  Re M] (Re x; Im x),
// which has each eigenvalue of a travelling wave twice. Neither the factor nor the modes of the program are used for
// it. theta = 1/lambda near 1e-9 makes Anasazi report complex eigenvalues that aren't there: K is scaled by a
// reference frequency.
#include <Epetra_Map.h>
#include <Epetra_SerialComm.h>
#include <gtest/gtest.h>
#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziEpetraAdapter.hpp>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

#include "reduce/basis/cyclic_modes.h"
#include "tests/reduce/dense_algebra.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

using test::TestRotor;
using MultiVector = Epetra_MultiVector;
using Operator = Epetra_Operator;

/// A linear map, as Epetra wants it.
class MappedOperator : public Epetra_Operator {
 public:
  MappedOperator(std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)> map, const Epetra_Map& rows)
      : map_(std::move(map)), rows_(rows) {}

  int Apply(const Epetra_MultiVector& X, Epetra_MultiVector& Y) const override {
    Eigen::Map<Eigen::MatrixXd>(Y.Values(), Y.MyLength(), Y.NumVectors()) =
        map_(Eigen::Map<const Eigen::MatrixXd>(X.Values(), X.MyLength(), X.NumVectors()));
    return 0;
  }
  int ApplyInverse(const Epetra_MultiVector&, Epetra_MultiVector&) const override { return -1; }
  int SetUseTranspose(bool use) override { return use ? -1 : 0; }
  double NormInf() const override { return 0.0; }
  const char* Label() const override { return "map"; }
  bool UseTranspose() const override { return false; }
  bool HasNormInf() const override { return false; }
  const Epetra_Comm& Comm() const override { return rows_.Comm(); }
  const Epetra_Map& OperatorDomainMap() const override { return rows_; }
  const Epetra_Map& OperatorRangeMap() const override { return rows_; }

 private:
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)> map_;
  Epetra_Map rows_;
};

Eigen::MatrixXd doubled(const Eigen::MatrixXcd& matrix) {
  Eigen::MatrixXd all(2 * matrix.rows(), 2 * matrix.cols());
  all << matrix.real(), -matrix.imag(), matrix.imag(), matrix.real();
  return all;
}

using Map = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/// The `count` lowest eigenvalues, ascending, from x -> reference K^-1 M x and x -> M x.
std::vector<double> by_anasazi(const Map& operate, const Map& weigh, Eigen::Index size, int count, double reference,
                               int block, double tolerance) {
  const Epetra_SerialComm here;
  const Epetra_Map rows(static_cast<int>(size), 0, here);
  const auto inverse = Teuchos::rcp(new MappedOperator(operate, rows));
  const auto weight = Teuchos::rcp(new MappedOperator(weigh, rows));
  const auto start = Teuchos::rcp(new MultiVector(rows, block));
  start->SetSeed(1);
  start->Random();
  const auto problem =
      Teuchos::rcp(new Anasazi::BasicEigenproblem<double, MultiVector, Operator>(inverse, weight, start));
  problem->setHermitian(true);
  problem->setNEV(count);
  EXPECT_TRUE(problem->setProblem());
  Teuchos::ParameterList options;
  options.set("Which", "LM");
  options.set("Block Size", block);
  options.set("Num Blocks", 2 * ((count + block - 1) / block) + 4);
  options.set("Maximum Restarts", 100);
  options.set("Convergence Tolerance", tolerance);
  options.set("Verbosity", static_cast<int>(Anasazi::Errors));
  Anasazi::BlockKrylovSchurSolMgr<double, MultiVector, Operator> solver(problem, options);
  EXPECT_EQ(solver.solve(), Anasazi::Converged);
  std::vector<double> eigenvalues;
  for (const auto& theta : problem->getSolution().Evals) eigenvalues.push_back(reference / theta.realpart);
  std::sort(eigenvalues.begin(), eigenvalues.end());
  return eigenvalues;
}

/// By a dense factor of the doubled problem: nothing of the program's own is in it.
std::vector<double> by_dense_anasazi(const Eigen::MatrixXcd& K, const Eigen::MatrixXcd& M, int count,
                                     double reference) {
  const Eigen::LLT<Eigen::MatrixXd> factor(doubled(K) / reference);
  const Eigen::MatrixXd mass = doubled(M);
  return by_anasazi([&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd { return factor.solve(mass * x); },
                    [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd { return mass * x; }, mass.rows(), count,
                    reference, 4, 1e-11);
}

/// (Re x; Im x) <-> x
Eigen::MatrixXcd joined(const Eigen::MatrixXd& halves) {
  const Eigen::Index rows = halves.rows() / 2;
  Eigen::MatrixXcd x(rows, halves.cols());
  x.real() = halves.topRows(rows);
  x.imag() = halves.bottomRows(rows);
  return x;
}

Eigen::MatrixXd halves(const Eigen::MatrixXcd& x) {
  Eigen::MatrixXd both(2 * x.rows(), x.cols());
  both << x.real(), x.imag();
  return both;
}

/// [s] of this process.
double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

TEST(Anasazi, FindsTheSameEigenvaluesEachTwice) {
  constexpr int sectors = 5, count = 10;
  TestRotor rotor = test::tip_rotor(test::skewed_annulus(sectors));
  const SymmetricMatrix stiffness = rotor.at_speed(2000.0, Prestress::linear), mass = rotor.mass();
  const SectorFactor factor(stiffness, rotor.dofs());
  for (int n = 0; n <= sectors / 2; ++n) {
    const CyclicModes modes =
        lowest_modes(CyclicSolver(factor, {rotor.dofs(), sectors, n}), mass, ContactNodes::free, count, 1e-9);
    const std::vector<double> other =
        by_dense_anasazi(test::cyclic(stiffness, rotor.dofs(), sectors, n),
                         test::cyclic(mass, rotor.dofs(), sectors, n), 2 * count, modes.eigenvalue[0]);
    ASSERT_GE(other.size(), 2u * count);
    for (int k = 0; k < 2 * count; ++k) EXPECT_NEAR(modes.eigenvalue[k / 2] / other[k], 1.0, 1e-9) << n << " " << k;
  }
}

// What decided for own code (see cyclic_modes.h): both on the same factor and mass, for the same modes to the same
// residual. Run it by --gtest_also_run_disabled_tests --gtest_filter=*Side*; it takes a minute.
TEST(Anasazi, DISABLED_SideBySideOnTheSameFactor) {
  constexpr int sectors = 10, nodal_diameter = 1, count = 40;
  constexpr double tolerance = 1e-4;
  test::Annulus annulus = test::skewed_annulus(sectors);
  annulus.bricks = {16, 16, 5};
  TestRotor rotor = test::tip_rotor(annulus);
  const SymmetricMatrix stiffness = rotor.at_rest(), mass = rotor.mass();
  const SectorFactor factor(stiffness, rotor.dofs());
  const CyclicSolver solver(factor, {rotor.dofs(), sectors, nodal_diameter});
  const double start = processor_time();
  const CyclicModes modes = lowest_modes(solver, mass, ContactNodes::free, count, tolerance);
  const double middle = processor_time();
  const double reference = modes.eigenvalue[0];
  const std::vector<double> other = by_anasazi(
      [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd {
        return reference * halves(solver.solve(solver.transform().apply(mass, joined(x)), ContactNodes::free));
      },
      [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd { return halves(solver.transform().apply(mass, joined(x))); },
      2 * static_cast<Eigen::Index>(rotor.dofs().independent()), 2 * count, reference, 8, tolerance);
  const double end = processor_time();
  std::printf("%d dofs a sector, %d modes: own %.2f s, Anasazi %.2f s, ratio %.1f\n", rotor.dofs().sector(), count,
              middle - start, end - middle, (end - middle) / (middle - start));
  ASSERT_GE(other.size(), 2u * count);
  for (int k = 0; k < 2 * count; ++k) EXPECT_NEAR(modes.eigenvalue[k / 2] / other[k], 1.0, 1e-6) << k;
}

}  // namespace
}  // namespace tiprub::reduce
