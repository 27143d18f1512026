// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/mode_following.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "cases/program/errors.h"
#include "reduce/basis/hermitian_products.h"

namespace tiprub {

namespace {

constexpr int longest = 30;                     // rounds before giving up
constexpr double dependence_tolerance = 1e-12;  // of a round's directions, in squared stiffness norm

Eigen::Index columns_of(const std::vector<Eigen::MatrixXcd>& blocks) {
  Eigen::Index columns = 0;
  for (const Eigen::MatrixXcd& block : blocks) columns += block.cols();
  return columns;
}

/// Side by side, for operators that are cheaper on many columns.
Eigen::MatrixXcd join(const std::vector<Eigen::MatrixXcd>& blocks) {
  Eigen::MatrixXcd all(blocks.front().rows(), columns_of(blocks));
  Eigen::Index first = 0;
  for (const Eigen::MatrixXcd& block : blocks) {
    all.middleCols(first, block.cols()) = block;
    first += block.cols();
  }
  return all;
}

/// Directions of unit length in the norm of the nearby stiffness. A residual is orthogonal to the basis, so what
/// becomes of it is so as well in that norm: only the new block has to be made independent.
Eigen::MatrixXcd independent(const Eigen::MatrixXcd& directions, const Eigen::MatrixXcd& residual) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> gram(hermitian_part(directions.adjoint() * residual));
  const Eigen::VectorXd& squares = gram.eigenvalues();
  const Eigen::Index kept = (squares.array() > dependence_tolerance * squares[squares.size() - 1]).count();
  return directions * gram.eigenvectors().rightCols(kept) *
         squares.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

Eigen::VectorXd FollowedModes::frequencies() const {
  return eigenvalue.cwiseSqrt() / (2 * std::numbers::pi);
}

ModeFollowing::ModeFollowing(const CraigBamptonBasis& basis, const SymmetricMatrix& mass,
                             std::vector<SpeedToFollow> speeds, int count)
    : basis_(basis),
      mass_(mass),
      speeds_(std::move(speeds)),
      count_(count),
      spaces_(speeds_.size()),
      modes_(speeds_.size()) {
  const Eigen::Index rows = basis.transform().dofs().independent();
  for (std::size_t s = 0; s < speeds_.size(); ++s) {
    spaces_[s] = {speeds_[s].reduced, basis.mass(), Eigen::MatrixXcd(rows, 0), {}};
    modes_[s].error = Eigen::VectorXd::Ones(count);
    solve(s);
  }
}

void ModeFollowing::solve(std::size_t speed) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> ritz(spaces_[speed].K, spaces_[speed].M);
  if (ritz.info() != Eigen::Success)
    throw RunError(speeds_[speed].where + ": the modes of a nodal diameter could not be followed");
  if (ritz.eigenvalues()[0] <= 0)
    throw RunError(speeds_[speed].where +
                   ": the stiffness of a nodal diameter is not positive definite: the rotor is unstable");
  spaces_[speed].weights = ritz.eigenvectors().leftCols(count_);
  modes_[speed].eigenvalue = ritz.eigenvalues().head(count_);
}

Eigen::MatrixXcd ModeFollowing::shapes(std::size_t speed, const std::vector<Eigen::Index>& which) const {
  const Space& space = spaces_[speed];
  const Eigen::MatrixXcd weights = space.weights(Eigen::all, which);
  Eigen::MatrixXcd shapes = basis_.combine(weights.topRows(basis_.size()));
  if (space.corrections.cols() > 0) shapes += space.corrections * weights.bottomRows(space.corrections.cols());
  return shapes;
}

std::vector<Eigen::MatrixXcd> ModeFollowing::missing(double tolerance) {
  const CyclicTransformation& transform = basis_.transform();
  std::vector<std::vector<Eigen::Index>> moving(speeds_.size());
  std::vector<Eigen::MatrixXcd> blocks(speeds_.size());
  for (std::size_t s = 0; s < speeds_.size(); ++s) {
    for (Eigen::Index mode = 0; mode < count_; ++mode)
      if (modes_[s].error[mode] > tolerance) moving[s].push_back(mode);
    blocks[s] = shapes(s, moving[s]);
  }
  if (columns_of(blocks) == 0) return blocks;
  Eigen::MatrixXcd residual = -transform.apply(mass_, join(blocks));
  Eigen::Index first = 0;
  for (std::size_t s = 0; s < speeds_.size(); ++s) {
    const Eigen::Index columns = blocks[s].cols();
    if (columns > 0)
      residual.middleCols(first, columns) =
          residual.middleCols(first, columns) * modes_[s].eigenvalue(moving[s]).asDiagonal() +
          transform.apply(speeds_[s].stiffness(), blocks[s]);
    first += columns;
  }
  const Eigen::MatrixXcd directions = precondition(blocks, residual);
  const Eigen::VectorXd work = residual.conjugate().cwiseProduct(directions).colwise().sum().real();
  first = 0;
  for (std::size_t s = 0; s < speeds_.size(); ++s) {
    const Eigen::Index columns = blocks[s].cols();
    Eigen::VectorXd& error = modes_[s].error;
    if (columns > 0) error(moving[s]) = work.segment(first, columns).cwiseQuotient(modes_[s].eigenvalue(moving[s]));
    std::vector<Eigen::Index> wanted;
    for (Eigen::Index k = 0; k < columns; ++k)
      if (error[moving[s][k]] > tolerance) wanted.push_back(first + k);
    blocks[s].resize(residual.rows(), 0);
    if (!wanted.empty()) blocks[s] = independent(directions(Eigen::all, wanted), residual(Eigen::all, wanted));
    first += columns;
  }
  return blocks;
}

/// Columns of `residual` by speed, as many as each block has: those that share a factor are solved together.
Eigen::MatrixXcd ModeFollowing::precondition(const std::vector<Eigen::MatrixXcd>& blocks,
                                             const Eigen::MatrixXcd& residual) const {
  std::map<const CyclicSolver*, std::vector<Eigen::Index>> columns;
  Eigen::Index first = 0;
  for (std::size_t s = 0; s < speeds_.size(); ++s)
    for (Eigen::Index k = 0; k < blocks[s].cols(); ++k) columns[speeds_[s].nearby].push_back(first++);
  Eigen::MatrixXcd directions(residual.rows(), residual.cols());
  for (const auto& [nearby, which] : columns)
    directions(Eigen::all, which) = nearby->solve(residual(Eigen::all, which), ContactNodes::fixed);
  return directions;
}

void ModeFollowing::add(const std::vector<Eigen::MatrixXcd>& blocks) {
  const CyclicTransformation& transform = basis_.transform();
  const Eigen::MatrixXcd all = join(blocks), mass_loads = transform.apply(mass_, all);
  Eigen::MatrixXcd stiffness_loads(all.rows(), all.cols());
  Eigen::Index first = 0;
  for (std::size_t s = 0; s < blocks.size(); ++s) {
    if (blocks[s].cols() > 0)
      stiffness_loads.middleCols(first, blocks[s].cols()) = transform.apply(speeds_[s].stiffness(), blocks[s]);
    first += blocks[s].cols();
  }
  const Eigen::MatrixXcd mass_products = basis_.inner_products(mass_loads);
  const Eigen::MatrixXcd stiffness_products = basis_.inner_products(stiffness_loads);
  first = 0;
  for (std::size_t s = 0; s < blocks.size(); ++s) {
    const Eigen::Index columns = blocks[s].cols();
    if (columns == 0) continue;
    Space& space = spaces_[s];
    const Eigen::Index old = space.corrections.cols();
    space.corrections.conservativeResize(all.rows(), old + columns);
    space.corrections.rightCols(columns) = blocks[s];
    Eigen::MatrixXcd products(space.K.cols() + columns, columns);
    products << stiffness_products.middleCols(first, columns),
        space.corrections.adjoint() * stiffness_loads.middleCols(first, columns);
    append_products(space.K, products);
    products << mass_products.middleCols(first, columns),
        space.corrections.adjoint() * mass_loads.middleCols(first, columns);
    append_products(space.M, products);
    solve(s);
    first += columns;
  }
}

void ModeFollowing::converge(double tolerance) {
  for (int round = 0; round < longest; ++round) {
    const std::vector<Eigen::MatrixXcd> blocks = missing(tolerance);
    if (columns_of(blocks) == 0) return;
    add(blocks);
  }
  throw RunError(speeds_.front().where + ": the modes of a nodal diameter could not be followed");
}

}  // namespace tiprub
