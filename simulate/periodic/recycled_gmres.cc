// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/recycled_gmres.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>

namespace tiprub::simulate {

namespace {

constexpr int most_steps = 200;          // of one solve
constexpr Eigen::Index most_kept = 320;  // directions
constexpr double new_direction = 1e-4;   // of a direction: a larger remainder beside the kept ones is kept
constexpr int few_steps = 24;            // of a solve: then its directions are not kept
constexpr int look = 4;                  // steps between two looks at the residual

}  // namespace

/// (1 - A) Z = V_{m+1} H, and the coefficients of the solution in Z.
struct RecycledGmres::Krylov {
  Eigen::MatrixXd basis, directions, hessenberg;
  Eigen::VectorXd coefficients;
  int size = 0;
  double residual = 1;  ///< of |f|
};

Eigen::VectorXd RecycledGmres::precondition(const Eigen::VectorXd& change) const {
  if (directions_.size() == 0) return change;
  return change + directions_ * (share_ * (directions_.transpose() * change));
}

RecycledGmres::Krylov RecycledGmres::build(const LinearMap& A, const Eigen::VectorXd& f, double tolerance, int most) {
  Krylov space{Eigen::MatrixXd(f.size(), most + 1),
               Eigen::MatrixXd(f.size(), most),
               Eigen::MatrixXd::Zero(most + 1, most),
               {}};
  const double size = f.norm();
  space.basis.col(0) = f / size;
  bool ended = false;
  while (space.residual > tolerance && space.size < most && !ended) {
    const int m = space.size++;
    ++steps_;
    space.directions.col(m) = precondition(space.basis.col(m));
    Eigen::VectorXd next = space.directions.col(m) - A(space.directions.col(m));
    for (int twice = 0; twice < 2; ++twice) {
      const Eigen::VectorXd shares = space.basis.leftCols(m + 1).transpose() * next;
      space.hessenberg.col(m).head(m + 1) += shares;
      next.noalias() -= space.basis.leftCols(m + 1) * shares;
    }
    const double length = space.hessenberg(m + 1, m) = next.norm();
    ended = !(length > 0);
    space.basis.col(m + 1) = ended ? next : Eigen::VectorXd(next / length);
    if (space.size % look != 0 && space.size < most && !ended) continue;
    const Eigen::MatrixXd small = space.hessenberg.topLeftCorner(m + 2, m + 1);
    const Eigen::VectorXd right = size * Eigen::VectorXd::Unit(m + 2, 0);
    space.coefficients = small.householderQr().solve(right);
    space.residual = (small * space.coefficients - right).norm() / size;
  }
  return space;
}

void RecycledGmres::keep(const Krylov& space) {
  Eigen::MatrixXd directions = space.directions.leftCols(space.size);
  Eigen::MatrixXd images =
      space.basis.leftCols(space.size + 1) * space.hessenberg.topLeftCorner(space.size + 1, space.size);
  const Eigen::Index old = directions_.cols();
  if (old > 0) {
    const Eigen::MatrixXd shares = directions_.transpose() * directions;
    directions.noalias() -= directions_ * shares;
    images.noalias() -= images_ * shares;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(directions.rows(), directions.cols());
  factor.setThreshold(new_direction);
  factor.compute(directions);
  const Eigen::Index added = std::min(factor.rank(), most_kept - old);
  if (added == 0) return;
  const Eigen::MatrixXd sorted = images * factor.colsPermutation();
  directions_.conservativeResize(directions.rows(), old + added);
  images_.conservativeResize(directions.rows(), old + added);
  directions_.rightCols(added) = factor.householderQ() * Eigen::MatrixXd::Identity(directions.rows(), added);
  images_.rightCols(added) = factor.matrixR()
                                 .topLeftCorner(added, added)
                                 .triangularView<Eigen::Upper>()
                                 .solve<Eigen::OnTheRight>(sorted.leftCols(added));
  share_ = (directions_.transpose() * images_).inverse() - Eigen::MatrixXd::Identity(old + added, old + added);
}

Eigen::VectorXd RecycledGmres::solve(const LinearMap& A, const Eigen::VectorXd& f, double tolerance) {
  if (!(f.norm() > 0)) return Eigen::VectorXd::Zero(f.size());
  const Krylov space = build(A, f, tolerance, std::min<int>(most_steps, static_cast<int>(f.size())));
  const Eigen::VectorXd solution = space.directions.leftCols(space.size) * space.coefficients;
  if (space.size > few_steps) keep(space);
  return solution;
}

}  // namespace tiprub::simulate
