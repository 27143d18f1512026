// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/multipliers.h"

#include <AnasaziConfigDefs.hpp>
// Its stopwatches are one set for all threads.
#undef ANASAZI_TEUCHOS_TIME_MONITOR

#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <Eigen/Eigenvalues>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "simulate/periodic/krylov_vectors.h"

namespace tiprub {

namespace {

constexpr Eigen::Index dense = 40;  // numbers of a state: fewer maps than a Krylov space
constexpr int most_vectors = 100;   // of a Krylov space
constexpr int vectors_a_look = 10;
constexpr int restarts = 6;

Teuchos::ParameterList settings(Eigen::Index size, double tolerance) {
  Teuchos::ParameterList list;
  list.set("Which", "LM");
  list.set("Block Size", 1);
  list.set("Num Blocks", static_cast<int>(std::min<Eigen::Index>(most_vectors, size - 2)));
  list.set("Step Size", vectors_a_look);
  list.set("Maximum Restarts", restarts);
  list.set("Convergence Tolerance", tolerance);
  list.set("Verbosity", static_cast<int>(Anasazi::Errors));
  return list;
}

std::complex<double> largest_of(const Eigen::VectorXcd& values) {
  Eigen::Index place = 0;
  values.cwiseAbs().maxCoeff(&place);
  return values[place];
}

/// Column by column.
Multiplier of_dense(const LinearMap& map, Eigen::Index size) {
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) matrix.col(i) = map(Eigen::VectorXd::Unit(size, i));
  const std::complex<double> largest = largest_of(Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues());
  return {largest, static_cast<double>(size) * std::numeric_limits<double>::epsilon() * matrix.norm()};
}

}  // namespace

Multiplier largest_multiplier(const LinearMap& map, Eigen::Index size, double tolerance) {
  if (size <= dense) return of_dense(map, size);
  const auto block = Teuchos::rcp(new KrylovVectors(size, 1));
  Anasazi::MultiVecTraits<double, KrylovVectors>::MvRandom(*block);
  const auto problem =
      Teuchos::rcp(new Anasazi::BasicEigenproblem<double, KrylovVectors, LinearMap>(Teuchos::rcpFromRef(map), block));
  problem->setHermitian(false);
  problem->setNEV(1);
  problem->setProblem();
  Teuchos::ParameterList list = settings(size, tolerance);
  Anasazi::BlockKrylovSchurSolMgr<double, KrylovVectors, LinearMap> solver(problem, list);
  const bool converged = solver.solve() == Anasazi::Converged;
  Multiplier largest;
  for (const Anasazi::Value<double>& value : solver.getRitzValues()) {
    const std::complex<double> candidate(value.realpart, value.imagpart);
    if (std::abs(candidate) > std::abs(largest.value)) largest.value = candidate;
  }
  largest.uncertainty = converged ? tolerance * std::abs(largest.value) : 1;
  return largest;
}

}  // namespace tiprub
