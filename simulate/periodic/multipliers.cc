// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/multipliers.h"

#include <AnasaziConfigDefs.hpp>
// Anasazi's timers are shared by all threads and not safe.
#undef ANASAZI_TEUCHOS_TIME_MONITOR

#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBasicOrthoManager.hpp>
#include <AnasaziBasicOutputManager.hpp>
#include <AnasaziBasicSort.hpp>
#include <AnasaziBlockKrylovSchur.hpp>
#include <AnasaziStatusTestMaxIters.hpp>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "reduce/model/dense_eigen.h"
#include "simulate/periodic/krylov_vectors.h"

namespace tiprub {

namespace {

constexpr Eigen::Index dense = 40;  // numbers in a state: up to here the whole matrix costs fewer maps
constexpr int fewest_vectors = 40, most_vectors = 200;  // of a Krylov space
constexpr int vectors_a_look = 10;

Teuchos::ParameterList settings(Eigen::Index vectors) {
  Teuchos::ParameterList list;
  list.set("Block Size", 1);
  list.set("Num Blocks", static_cast<int>(vectors));
  list.set("Step Size", static_cast<int>(vectors) + 1);  // no Ritz values before we ask
  return list;
}

/// By the whole matrix, column by column.
Multiplier of_dense(const LinearMap& map, Eigen::Index size) {
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) matrix.col(i) = map(Eigen::VectorXd::Unit(size, i));
  const Eigen::VectorXcd values = general_eigenvalues(matrix);
  Eigen::Index largest = 0;
  values.cwiseAbs().maxCoeff(&largest);
  return {values[largest], static_cast<double>(size) * std::numeric_limits<double>::epsilon() * matrix.norm()};
}

using Solver = Anasazi::BlockKrylovSchur<double, KrylovVectors, LinearMap>;

std::complex<double> largest_ritz_value(Solver& solver) {
  solver.computeRitzValues();
  std::complex<double> largest;
  for (const Anasazi::Value<double>& value : solver.getRitzValues()) {
    const std::complex<double> candidate(value.realpart, value.imagpart);
    if (std::abs(candidate) > std::abs(largest)) largest = candidate;
  }
  return largest;
}

/// The largest Ritz value of a growing Krylov space, until its magnitude is constant over two looks. For a march,
/// whose map is nearly normal, the value converges long before its vector, since many multipliers are of nearly equal
/// size.
Multiplier of_krylov(const LinearMap& map, Eigen::Index size, double tolerance) {
  using Test = Anasazi::StatusTestMaxIters<double, KrylovVectors, LinearMap>;
  const auto start = Teuchos::rcp(new KrylovVectors(size, 1));
  Anasazi::MultiVecTraits<double, KrylovVectors>::MvRandom(*start);
  const auto problem =
      Teuchos::rcp(new Anasazi::BasicEigenproblem<double, KrylovVectors, LinearMap>(Teuchos::rcpFromRef(map), start));
  problem->setHermitian(false);
  problem->setNEV(1);
  problem->setProblem();
  const auto vectors = static_cast<int>(std::min<Eigen::Index>(most_vectors, size - 2));
  Teuchos::ParameterList list = settings(vectors);
  Solver solver(problem, Teuchos::rcp(new Anasazi::BasicSort<double>("LM")),
                Teuchos::rcp(new Anasazi::BasicOutputManager<double>(Anasazi::Errors)),
                Teuchos::rcp(new Test(vectors_a_look)),
                Teuchos::rcp(new Anasazi::BasicOrthoManager<double, KrylovVectors, LinearMap>), list);
  Multiplier largest{0, 1};
  double change_before = 1;
  for (int look = vectors_a_look; look <= vectors; look += vectors_a_look) {
    solver.setStatusTest(Teuchos::rcp(new Test(look)));
    solver.iterate();
    const std::complex<double> now = largest_ritz_value(solver);
    const double change = std::abs(std::abs(now) - std::abs(largest.value));
    largest = {now, std::max(change, change_before)};
    change_before = change;
    if (look >= fewest_vectors && largest.uncertainty <= tolerance * std::abs(now)) break;
  }
  return largest;
}

}  // namespace

Multiplier largest_multiplier(const LinearMap& map, Eigen::Index size, double tolerance) {
  return size <= dense ? of_dense(map, size) : of_krylov(map, size, tolerance);
}

Growth per_revolution(const Multiplier& multiplier, double maps) {
  const double magnitude = std::abs(multiplier.value), factor = std::pow(magnitude, maps);
  return {factor, magnitude > 0 ? maps * factor * multiplier.uncertainty / magnitude : multiplier.uncertainty};
}

}  // namespace tiprub
