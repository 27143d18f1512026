// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/QR>
#include <algorithm>

#include "simulate/periodic/periodic_map.h"

namespace tiprub::simulate {

namespace {

constexpr Eigen::Index most_steps = 200;
constexpr Eigen::Index look = 2;  // steps between two looks at the residual

}  // namespace

Eigen::VectorXd gmres(const LinearMap& A, const LinearMap& precondition, const Eigen::VectorXd& f, double tolerance) {
  const double size = f.norm();
  if (!(size > 0)) return Eigen::VectorXd::Zero(f.size());
  const Eigen::Index most = std::min(most_steps, f.size());
  // (1 - A) Z = V_{m+1} H, and the coefficients of the solution in Z
  Eigen::MatrixXd basis(f.size(), most + 1), directions(f.size(), most);
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most + 1, most);
  Eigen::VectorXd coefficients;
  basis.col(0) = f / size;
  for (Eigen::Index m = 0; m < most; ++m) {
    directions.col(m) = precondition(basis.col(m));
    Eigen::VectorXd next = directions.col(m) - A(directions.col(m));
    for (int twice = 0; twice < 2; ++twice) {
      const Eigen::VectorXd shares = basis.leftCols(m + 1).transpose() * next;
      hessenberg.col(m).head(m + 1) += shares;
      next.noalias() -= basis.leftCols(m + 1) * shares;
    }
    const double length = hessenberg(m + 1, m) = next.norm();
    const bool is_last = !(length > 0) || m + 1 == most;
    if (length > 0) basis.col(m + 1) = next / length;
    if ((m + 1) % look != 0 && !is_last) continue;
    const Eigen::MatrixXd small = hessenberg.topLeftCorner(m + 2, m + 1);
    const Eigen::VectorXd right = size * Eigen::VectorXd::Unit(m + 2, 0);
    coefficients = small.householderQr().solve(right);
    if (is_last || (small * coefficients - right).norm() <= tolerance * size) break;
  }
  return directions.leftCols(coefficients.size()) * coefficients;
}

}  // namespace tiprub::simulate
