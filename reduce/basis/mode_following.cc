// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/mode_following.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "cases/program/errors.h"
#include "reduce/basis/craig_bampton.h"
#include "reduce/model/dense_eigen.h"

namespace tiprub::reduce {

namespace {

constexpr int longest = 30;                    // rounds before giving up
constexpr double direction_tolerance = 1e-12;  // of a round's directions, in squared stiffness norm

// The fraction of a tolerance that an error must stay below if it is only guessed from the largest compliance.
constexpr double of_a_guess = 0.1;

/// Makes directions independent, with unit length in the norm of the nearby stiffness. A residual is orthogonal to
/// the basis, so its direction is orthogonal to the basis in that norm, and only the new block has to be made
/// independent.
Eigen::MatrixXcd independent(const Eigen::MatrixXcd& directions, const Eigen::MatrixXcd& residual) {
  const auto [squares, vectors] = eigenpairs(hermitian_part(directions.adjoint() * residual));
  const Eigen::Index kept = (squares.array() > direction_tolerance * squares[squares.size() - 1]).count();
  return directions * vectors.rightCols(kept) * squares.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

Eigen::VectorXd FollowedModes::frequencies() const {
  return eigenvalue.cwiseSqrt() / (2 * std::numbers::pi);
}

ModeFollowing::ModeFollowing(const CraigBamptonBasis& basis, const SymmetricMatrix& mass,
                             const std::vector<SymmetricMatrix>& sampled_stiffness, std::vector<SpeedToFollow> speeds,
                             int count)
    : basis_(basis),
      mass_(mass),
      sampled_stiffness_(sampled_stiffness),
      speeds_(std::move(speeds)),
      count_(count),
      corrections_(basis.transform().dofs().independent(), 0),
      reduced_mass_(basis.mass()),
      weights_(speeds_.size()),
      modes_(speeds_.size()) {
  for (std::size_t s = 0; s < speeds_.size(); ++s) {
    reduced_stiffness_.push_back(speeds_[s].reduced);
    modes_[s].error = Eigen::VectorXd::Ones(count);
    solve(s);
  }
}

void ModeFollowing::solve(std::size_t speed) {
  const ComplexEigenpairs ritz = eigenpairs(reduced_stiffness_[speed], reduced_mass_);
  if (!ritz.values.allFinite())
    throw RunError(speeds_[speed].where + ": the modes of a nodal diameter could not be followed");
  if (ritz.values[0] <= 0)
    throw RunError(speeds_[speed].where +
                   ": the stiffness of a nodal diameter is not positive definite: the rotor is unstable");
  weights_[speed] = ritz.vectors.leftCols(count_);
  modes_[speed].eigenvalue = ritz.values.head(count_);
}

Eigen::MatrixXcd ModeFollowing::shapes(std::size_t speed, const std::vector<Eigen::Index>& which) const {
  const Eigen::MatrixXcd weights = weights_[speed](Eigen::all, which);
  Eigen::MatrixXcd shapes = basis_.combine(weights.topRows(basis_.size()));
  if (corrections_.cols() > 0) shapes += corrections_ * weights.bottomRows(corrections_.cols());
  return shapes;
}

Eigen::MatrixXcd ModeFollowing::missing(std::size_t speed, double tolerance) {
  const CyclicTransformation& transform = basis_.transform();
  FollowedModes& modes = modes_[speed];
  std::vector<Eigen::Index> moving, doubtful, wanted;
  for (Eigen::Index mode = 0; mode < count_; ++mode)
    if (modes.error[mode] > tolerance) moving.push_back(mode);
  if (moving.empty()) return {corrections_.rows(), 0};
  const Eigen::MatrixXcd moved = shapes(speed, moving);
  Eigen::MatrixXcd residual = stiffness_times(moved, speed);
  residual -= transform.apply(mass_, moved) * modes.eigenvalue(moving).asDiagonal();
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const double guess = compliance_ * residual.col(column).squaredNorm() / modes.eigenvalue[moving[k]];
    if (guess <= of_a_guess * tolerance)
      modes.error[moving[k]] = guess;
    else
      doubtful.push_back(column);
  }
  if (doubtful.empty()) return {corrections_.rows(), 0};
  residual = residual(Eigen::all, doubtful).eval();
  const Eigen::MatrixXcd directions = speeds_[speed].nearby->solve(residual, ContactNodes::fixed);
  const Eigen::VectorXd work = residual.conjugate().cwiseProduct(directions).colwise().sum().real();
  const double compliance = work.cwiseQuotient(residual.colwise().squaredNorm().transpose()).maxCoeff();
  compliance_ = std::isinf(compliance_) ? compliance : std::max(compliance_, compliance);
  for (std::size_t k = 0; k < doubtful.size(); ++k) {
    const Eigen::Index mode = moving[doubtful[k]];
    modes.error[mode] = work[static_cast<Eigen::Index>(k)] / modes.eigenvalue[mode];
    if (modes.error[mode] > tolerance) wanted.push_back(static_cast<Eigen::Index>(k));
  }
  if (wanted.empty()) return {corrections_.rows(), 0};
  return independent(directions(Eigen::all, wanted), residual(Eigen::all, wanted));
}

/// Without the sum of the matrices, which would take longer.
Eigen::MatrixXcd ModeFollowing::stiffness_times(const Eigen::MatrixXcd& shapes, std::size_t speed) const {
  const Eigen::VectorXd& weights = speeds_[speed].weights;
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(shapes.rows(), shapes.cols());
  for (Eigen::Index k = 0; k < weights.size(); ++k)
    if (weights[k] != 0)
      sum += weights[k] * basis_.transform().apply(sampled_stiffness_[static_cast<std::size_t>(k)], shapes);
  return sum;
}

/// Inner products of the basis and the corrections with loads; size x columns.
Eigen::MatrixXcd ModeFollowing::products(const Eigen::MatrixXcd& loads) const {
  Eigen::MatrixXcd all(basis_.size() + corrections_.cols(), loads.cols());
  all << basis_.inner_products(loads), corrections_.adjoint() * loads;
  return all;
}

void ModeFollowing::add(const Eigen::MatrixXcd& block) {
  const CyclicTransformation& transform = basis_.transform();
  corrections_.conservativeResize(block.rows(), corrections_.cols() + block.cols());
  corrections_.rightCols(block.cols()) = block;
  append_products(reduced_mass_, products(transform.apply(mass_, block)));
  std::vector<Eigen::MatrixXcd> sums(speeds_.size(), Eigen::MatrixXcd::Zero(reduced_mass_.rows(), block.cols()));
  for (std::size_t k = 0; k < sampled_stiffness_.size(); ++k) {
    const auto weight = [&](std::size_t s) { return speeds_[s].weights[static_cast<Eigen::Index>(k)]; };
    Eigen::MatrixXcd of_sample;  // found at the first speed that needs it
    for (std::size_t s = 0; s < speeds_.size(); ++s) {
      if (weight(s) == 0) continue;
      if (of_sample.size() == 0) of_sample = products(transform.apply(sampled_stiffness_[k], block));
      sums[s] += weight(s) * of_sample;
    }
  }
  for (std::size_t s = 0; s < speeds_.size(); ++s) {
    append_products(reduced_stiffness_[s], sums[s]);
    solve(s);
  }
}

bool ModeFollowing::correct(double tolerance) {
  const Eigen::Index before = corrections_.cols();
  for (std::size_t s = 0; s < speeds_.size(); ++s) {
    const Eigen::MatrixXcd block = missing(s, tolerance);
    if (block.cols() > 0) add(block);
  }
  return corrections_.cols() > before;
}

void ModeFollowing::converge(double tolerance) {
  for (int round = 0; round < longest; ++round)
    if (!correct(tolerance)) return;
  throw RunError(speeds_.front().where + ": the modes of a nodal diameter could not be followed");
}

}  // namespace tiprub::reduce
