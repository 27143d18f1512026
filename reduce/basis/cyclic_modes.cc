// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/basis/cyclic_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "cases/program/errors.h"
#include "cases/program/text.h"
#include "reduce/model/dense_eigen.h"

namespace tiprub::reduce {

namespace {

constexpr Eigen::Index block_size = 8;
constexpr double rank_tolerance = 1e-12;  // of the largest direction of a block, in squares
constexpr double rounding = 1e-13;        // of a new block before it was orthogonalised

/// The same noise in each run. It is real for a standing wave, because its modes must be real.
Eigen::MatrixXcd reproducible_noise(Eigen::Index rows, Eigen::Index columns, bool real) {
  std::mt19937_64 generator(1);
  const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1.0p-52 - 1.0; };
  Eigen::MatrixXcd noise(rows, columns);
  for (Eigen::Index i = 0; i < noise.size(); ++i) noise.data()[i] = {uniform(), real ? 0.0 : uniform()};
  return noise;
}

/// The growing Krylov space: M-orthonormal vectors Q, M Q beside them, and the projected operator.
class KrylovSpace {
 public:
  KrylovSpace(const CyclicSolver& stiffness, const SymmetricMatrix& mass, ContactNodes contact)
      : stiffness_(stiffness), mass_(mass), contact_(contact) {}

  Eigen::Index size() const { return size_; }
  const Eigen::MatrixXcd& projected() const { return projected_; }
  /// The coupling of the last step's new block with the block before; its norm bounds the residuals.
  const Eigen::MatrixXcd& coupling() const { return coupling_; }
  Eigen::MatrixXcd combine(const Eigen::MatrixXcd& weights) const { return Q_.leftCols(weights.rows()) * weights; }

  void start() {
    const SectorDofs& dofs = stiffness_.transform().dofs();
    const Eigen::Index width = std::min<Eigen::Index>(block_size, free_dofs());
    const Eigen::MatrixXcd noise = reproducible_noise(dofs.independent(), width, stiffness_.transform().is_real());
    append(stiffness_.solve(noise, contact_), 0.0);
    operated_ = 0;
  }

  /// Applies the operator to the newest block. Returns false when the space is invariant.
  bool grow() {
    const Eigen::Index old = size_, width = size_ - operated_;
    if (width == 0) return false;
    Eigen::MatrixXcd next = stiffness_.solve(MQ_.middleCols(operated_, width), contact_);
    Eigen::MatrixXcd column = Eigen::MatrixXcd::Zero(old, width);
    // In exact arithmetic a block overlaps with the last two blocks only. A second pass, over all blocks, removes
    // what rounding adds.
    for (const Eigen::Index from : {std::max<Eigen::Index>(operated_ - block_size, 0), Eigen::Index{0}}) {
      const Eigen::MatrixXcd part = MQ_.middleCols(from, old - from).adjoint() * next;
      next -= Q_.middleCols(from, old - from) * part;
      column.middleRows(from, old - from) += part;
    }
    projected_.conservativeResizeLike(Eigen::MatrixXcd::Zero(old, old));
    projected_.middleCols(operated_, width) = column;
    operated_ = old;
    append(next, column.colwise().norm().maxCoeff());
    return size_ > old;
  }

 private:
  Eigen::Index free_dofs() const {
    const SectorDofs& dofs = stiffness_.transform().dofs();
    return dofs.independent() - (contact_ == ContactNodes::fixed ? dofs.contact_dofs() : 0);
  }

  /// M-orthonormalises a block that is M-orthogonal to Q, and appends it. Directions shorter than `reference` times
  /// rounding, or without rank within the block, are dropped.
  void append(Eigen::MatrixXcd block, double reference) {
    const Eigen::Index room = free_dofs() - size_;
    double floor = std::pow(rounding * reference, 2);
    coupling_ = Eigen::MatrixXcd::Identity(block.cols(), block.cols());
    Eigen::MatrixXcd moved = stiffness_.transform().apply(mass_, block);
    for (int pass = 0; pass < 2 && block.cols() > 0; ++pass, floor = 0) {
      const auto [squares, directions] = eigenpairs(Eigen::MatrixXcd(block.adjoint() * moved));
      if (!squares.allFinite())
        throw RunError(
            "the modes of a nodal diameter can't be found: its stiffness or its mass is out of all bounds");
      const double least = std::max(floor, rank_tolerance * squares[squares.size() - 1]);
      const Eigen::Index kept = std::min<Eigen::Index>((squares.array() > least).count(), room);
      const Eigen::MatrixXcd basis = directions.rightCols(kept);
      const Eigen::VectorXd norms = squares.tail(kept).cwiseSqrt();
      coupling_ = norms.asDiagonal() * (basis.adjoint() * coupling_);
      const Eigen::MatrixXcd scaled = basis * norms.cwiseInverse().asDiagonal();
      block = block * scaled;
      moved = moved * scaled;
    }
    // Appending columns moves memory pages, not numbers, so reserving room would gain nothing.
    Q_.conservativeResize(block.rows(), size_ + block.cols());
    MQ_.conservativeResize(block.rows(), size_ + block.cols());
    Q_.middleCols(size_, block.cols()) = block;
    MQ_.middleCols(size_, block.cols()) = moved.leftCols(block.cols());
    size_ += block.cols();
  }

  const CyclicSolver& stiffness_;
  const SymmetricMatrix& mass_;
  ContactNodes contact_;
  Eigen::MatrixXcd Q_, MQ_, projected_, coupling_;
  Eigen::Index size_ = 0, operated_ = 0;
};

}  // namespace

Eigen::VectorXd CyclicModes::frequencies() const {
  return eigenvalue.cwiseSqrt() / (2 * std::numbers::pi);
}

CyclicModes lowest_modes(const CyclicSolver& stiffness, const SymmetricMatrix& mass, ContactNodes contact, int count,
                         double tolerance) {
  constexpr int longest = 20;  // Krylov vectors per wanted mode before giving up
  KrylovSpace space(stiffness, mass, contact);
  space.start();
  if (space.size() == 0) throw RunError("a nodal diameter has no modes: nothing of it moves, or its mass is nothing");
  while (true) {
    const bool more = space.grow();
    const Eigen::MatrixXcd& projected = space.projected();
    const Eigen::Index size = projected.cols();
    // Only the blocks on and above the diagonal are filled in; the solver reads the lower triangle.
    const ComplexEigenpairs ritz = eigenpairs(Eigen::MatrixXcd(projected.adjoint()));
    const Eigen::Index wanted = std::min<Eigen::Index>(count, size);
    const Eigen::VectorXd theta = ritz.values.tail(wanted).reverse();
    const Eigen::MatrixXcd weights = ritz.vectors.rightCols(wanted).rowwise().reverse();
    const Eigen::Index width = space.coupling().cols();
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(wanted);
    if (more) residual = (space.coupling() * weights.bottomRows(width)).colwise().norm().transpose();
    residual = residual.cwiseQuotient(theta);
    if (!more || (wanted == count && residual.maxCoeff() < tolerance)) {
      if (wanted < count)
        throw RunError(text_of(
            "a nodal diameter has only ", wanted, " modes, ", count,
            " are asked for; lower fixed_interface_modes or verification_modes, raise accuracy, or refine the mesh"));
      return {theta.cwiseInverse(), space.combine(weights), residual};
    }
    if (size > static_cast<Eigen::Index>(longest) * std::max(count, static_cast<int>(block_size)))
      throw RunError(text_of("the modes of a nodal diameter did not converge in ", size, " Krylov vectors"));
  }
}

}  // namespace tiprub::reduce
