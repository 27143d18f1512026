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
#include <AnasaziMultiVecTraits.hpp>
#include <AnasaziOperatorTraits.hpp>
#include <AnasaziStatusTestMaxIters.hpp>
#include <Eigen/Dense>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>
#include <Teuchos_SerialDenseMatrix.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "reduce/model/dense_eigen.h"

namespace tiprub::simulate {

/// The vectors of Anasazi as columns of one matrix, so that products of many vectors are matrix products. Copies and
/// views share the matrix.
struct KrylovVectors {
  std::shared_ptr<Eigen::MatrixXd> all;
  Eigen::Index first = 0, count = 0;

  KrylovVectors(Eigen::Index length, Eigen::Index columns)
      : all(std::make_shared<Eigen::MatrixXd>(Eigen::MatrixXd::Zero(length, columns))), count(columns) {}
  /// A view of neighbouring columns of another object.
  KrylovVectors(const KrylovVectors& other, Eigen::Index from, Eigen::Index columns)
      : all(other.all), first(other.first + from), count(columns) {}

  auto columns() { return all->middleCols(first, count); }
  auto columns() const { return std::as_const(*all).middleCols(first, count); }
};

}  // namespace tiprub::simulate

namespace Anasazi {

/// What the solvers below call. Index lists hold neighbouring columns: Anasazi asks for no others with blocks of one
/// vector.
template <>
class MultiVecTraits<double, tiprub::simulate::KrylovVectors> {
  using MV = tiprub::simulate::KrylovVectors;
  using Small = Teuchos::SerialDenseMatrix<int, double>;
  static auto view(const Small& small) {
    return Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>(
        small.values(), small.numRows(), small.numCols(), Eigen::OuterStride<>(small.stride()));
  }

 public:
  static Teuchos::RCP<MV> Clone(const MV& mv, int count) { return Teuchos::rcp(new MV(mv.all->rows(), count)); }
  static Teuchos::RCP<MV> CloneCopy(const MV& mv) {
    Teuchos::RCP<MV> copy = Clone(mv, static_cast<int>(mv.count));
    copy->columns() = mv.columns();
    return copy;
  }
  static Teuchos::RCP<MV> CloneCopy(const MV& mv, const std::vector<int>& index) {
    return CloneCopy(*CloneView(mv, index));
  }
  static Teuchos::RCP<MV> CloneViewNonConst(MV& mv, const std::vector<int>& index) {
    return Teuchos::rcp(new MV(mv, index.front(), static_cast<Eigen::Index>(index.size())));
  }
  static Teuchos::RCP<const MV> CloneView(const MV& mv, const std::vector<int>& index) {
    return Teuchos::rcp(new MV(mv, index.front(), static_cast<Eigen::Index>(index.size())));
  }
  static ptrdiff_t GetGlobalLength(const MV& mv) { return mv.all->rows(); }
  static int GetNumberVecs(const MV& mv) { return static_cast<int>(mv.count); }
  static void MvTimesMatAddMv(double alpha, const MV& A, const Small& B, double beta, MV& mv) {
    const Eigen::MatrixXd product = alpha * (A.columns() * view(B));
    if (beta == 0)
      mv.columns() = product;
    else
      mv.columns() = beta * mv.columns() + product;
  }
  static void MvAddMv(double alpha, const MV& A, double beta, const MV& B, MV& mv) {
    mv.columns() = (alpha * A.columns() + beta * B.columns()).eval();
  }
  static void MvTransMv(double alpha, const MV& A, const MV& mv, Small& B) {
    Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> into(B.values(), B.numRows(), B.numCols(),
                                                              Eigen::OuterStride<>(B.stride()));
    into.noalias() = alpha * (A.columns().transpose() * mv.columns());
  }
  static void MvDot(const MV& mv, const MV& A, std::vector<double>& dots) {
    for (Eigen::Index i = 0; i < mv.count; ++i)
      dots[static_cast<std::size_t>(i)] = mv.columns().col(i).dot(A.columns().col(i));
  }
  static void MvNorm(const MV& mv, std::vector<double>& norms) {
    for (Eigen::Index i = 0; i < mv.count; ++i) norms[static_cast<std::size_t>(i)] = mv.columns().col(i).norm();
  }
  static void SetBlock(const MV& A, const std::vector<int>& index, MV& mv) {
    mv.all->middleCols(mv.first + index.front(), static_cast<Eigen::Index>(index.size())) =
        A.columns().leftCols(static_cast<Eigen::Index>(index.size())).eval();
  }
  static void MvScale(MV& mv, double alpha) { mv.columns() *= alpha; }
  static void MvScale(MV& mv, const std::vector<double>& alpha) {
    for (Eigen::Index i = 0; i < mv.count; ++i) mv.columns().col(i) *= alpha[static_cast<std::size_t>(i)];
  }
  /// Always the same numbers, so that equal runs give equal bits.
  static void MvRandom(MV& mv) {
    std::mt19937 source(1);
    for (Eigen::Index column = 0; column < mv.count; ++column)
      for (Eigen::Index row = 0; row < mv.all->rows(); ++row)
        mv.columns()(row, column) = 2.0 * source() / std::mt19937::max() - 1.0;
  }
  static void MvInit(MV& mv, double value = 0) { mv.columns().setConstant(value); }
  static void MvPrint(const MV& mv, std::ostream& stream) { stream << mv.columns() << '\n'; }
};

template <>
class OperatorTraits<double, tiprub::simulate::KrylovVectors, tiprub::simulate::LinearMap> {
 public:
  static void Apply(const tiprub::simulate::LinearMap& map, const tiprub::simulate::KrylovVectors& from,
                    tiprub::simulate::KrylovVectors& to) {
    for (Eigen::Index i = 0; i < from.count; ++i) to.columns().col(i) = map(from.columns().col(i));
  }
};

}  // namespace Anasazi

namespace tiprub::simulate {

namespace {

constexpr Eigen::Index dense = 40;  // numbers in a state: up to here the whole matrix costs fewer maps
constexpr int fewest_vectors = 40, most_vectors = 200;  // of a Krylov space
constexpr int looks_to_double = 4;                      // between two looks the space grows by one part in so many
constexpr double clear_distance = 5;                    // of a magnitude from 1, in uncertainties
constexpr double invariant = 1e-10;                     // of the map: what leads out of a space is rounding

Teuchos::ParameterList settings(Eigen::Index vectors) {
  Teuchos::ParameterList list;
  list.set("Block Size", 1);
  list.set("Num Blocks", static_cast<int>(vectors));
  list.set("Step Size", static_cast<int>(vectors) + 1);  // no Ritz values before we ask
  return list;
}

std::complex<double> largest_eigenvalue(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXcd values = general_eigenvalues(matrix);
  Eigen::Index place = 0;
  values.cwiseAbs().maxCoeff(&place);
  return values[place];
}

/// By the whole matrix, column by column.
Multiplier of_dense(const LinearMap& map, Eigen::Index size) {
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) matrix.col(i) = map(Eigen::VectorXd::Unit(size, i));
  return {largest_eigenvalue(matrix),
          static_cast<double>(size) * std::numeric_limits<double>::epsilon() * matrix.norm()};
}

using Solver = Anasazi::BlockKrylovSchur<double, KrylovVectors, LinearMap>;

/// The projected map, without the vectors that follow once the space is invariant, which are rounding. Its
/// eigenvalues alone are much cheaper than Anasazi's Schur vectors.
Eigen::MatrixXd projected(const Solver& solver) {
  const auto state = solver.getState();
  const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> hessenberg(
      state.H->values(), state.curDim, state.curDim, Eigen::OuterStride<>(state.H->stride()));
  const double smallest = invariant * hessenberg.cwiseAbs().maxCoeff();
  Eigen::Index count = 1;
  while (count < state.curDim && std::abs(hessenberg(count, count - 1)) > smallest) ++count;
  return hessenberg.topLeftCorner(count, count);
}

bool is_exact_enough(const Multiplier& largest, const MultiplierGoal& goal) {
  const double magnitude = std::abs(largest.value);
  const bool is_clear = std::abs(magnitude - 1) > clear_distance * largest.uncertainty;
  return largest.uncertainty <= (is_clear ? goal.tolerance : std::min(goal.clear, goal.tolerance)) * magnitude;
}

/// The largest Ritz value of a growing Krylov space, until its magnitude is constant over three looks. For a march,
/// whose map is nearly normal, the value converges long before its vector, since many multipliers are of nearly equal
/// size.
Multiplier of_krylov(const LinearMap& map, Eigen::Index size, const MultiplierGoal& goal) {
  using Test = Anasazi::StatusTestMaxIters<double, KrylovVectors, LinearMap>;
  const auto start = Teuchos::rcp(new KrylovVectors(size, 1));
  if (goal.start.size() > 0)
    start->columns() = goal.start;
  else
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
                Teuchos::rcp(new Test(fewest_vectors)),
                Teuchos::rcp(new Anasazi::BasicOrthoManager<double, KrylovVectors, LinearMap>), list);
  Multiplier largest{0, 1};
  std::array<double, 3> changes{1, 1, 1};  // the last ones
  for (int look = std::min(fewest_vectors / 2, vectors);; look = std::min(look + look / looks_to_double, vectors)) {
    solver.setStatusTest(Teuchos::rcp(new Test(look)));
    solver.iterate();
    const Eigen::MatrixXd small = projected(solver);
    const std::complex<double> now = largest_eigenvalue(small);
    changes = {changes[1], changes[2], std::abs(std::abs(now) - std::abs(largest.value))};
    largest = {now, *std::ranges::max_element(changes)};
    const bool is_whole = look == vectors || small.rows() < look;
    if (is_whole || (look >= fewest_vectors && is_exact_enough(largest, goal))) return largest;
  }
}

}  // namespace

Multiplier largest_multiplier(const LinearMap& map, Eigen::Index size, const MultiplierGoal& goal) {
  return size <= dense ? of_dense(map, size) : of_krylov(map, size, goal);
}

}  // namespace tiprub::simulate
