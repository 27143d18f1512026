// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/mode_following.h"

#include <Eigen/Eigenvalues>
#include <numeric>
#include <vector>

#include "cases/errors.h"

namespace tiprub {

namespace {

constexpr int longest = 30;                     // steps before giving up
constexpr double dependence_tolerance = 1e-20;  // of a new block, in squared mass norm

/// A growing M-orthonormal basis with what K makes of it.
class RitzBasis {
 public:
  RitzBasis(const TravellingWave& wave, const SymmetricMatrix& stiffness, const SymmetricMatrix& mass)
      : wave_(wave), stiffness_(stiffness), mass_(mass) {}

  void append(Eigen::MatrixXcd block) {
    if (V_.cols() > 0) block -= V_ * (MV_.adjoint() * block);
    Eigen::MatrixXcd moved = wave_.apply(mass_, block);
    for (int pass = 0; pass < 2; ++pass) {  // once is not enough in finite precision
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> gram(block.adjoint() * moved);
      const Eigen::VectorXd& squares = gram.eigenvalues();
      const Eigen::Index kept = (squares.array() > dependence_tolerance * squares[squares.size() - 1]).count();
      const Eigen::MatrixXcd scaled =
          gram.eigenvectors().rightCols(kept) * squares.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
      block = block * scaled;
      moved = moved * scaled;
      if (V_.cols() == 0) continue;
      const Eigen::MatrixXcd overlap = MV_.adjoint() * block;
      block -= V_ * overlap;
      moved -= MV_ * overlap;
    }
    join(V_, block);
    join(MV_, moved);
    join(KV_, wave_.apply(stiffness_, block));
  }

  CyclicModes lowest(Eigen::Index count) {
    const Eigen::MatrixXcd projected = V_.adjoint() * KV_;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> ritz(0.5 * (projected + projected.adjoint()));
    if (ritz.eigenvalues()[0] <= 0)
      throw RunError("the stiffness of a nodal diameter is not positive definite: the rotor is unstable");
    weights_ = ritz.eigenvectors().leftCols(count);
    return {ritz.eigenvalues().head(count), V_ * weights_, Eigen::VectorXd::Zero(count)};
  }
  /// K x - M x omega^2 of some of the modes that lowest() gave last.
  Eigen::MatrixXcd residual(const Eigen::VectorXd& eigenvalue, const std::vector<Eigen::Index>& which) const {
    const Eigen::MatrixXcd weights = weights_(Eigen::all, which);
    return KV_ * weights - MV_ * weights * eigenvalue(which).asDiagonal();
  }

 private:
  static void join(Eigen::MatrixXcd& all, const Eigen::MatrixXcd& block) {
    const Eigen::Index old = all.cols();
    all.conservativeResize(block.rows(), old + block.cols());
    all.rightCols(block.cols()) = block;
  }

  const TravellingWave& wave_;
  const SymmetricMatrix& stiffness_;
  const SymmetricMatrix& mass_;
  Eigen::MatrixXcd V_, MV_, KV_, weights_;
};

}  // namespace

CyclicModes follow_modes(const CyclicStiffness& nearby, const SymmetricMatrix& stiffness, const SymmetricMatrix& mass,
                         const Eigen::MatrixXcd& guesses, int count, double tolerance) {
  RitzBasis basis(nearby.wave(), stiffness, mass);
  basis.append(guesses);
  CyclicModes modes = basis.lowest(count);
  std::vector<Eigen::Index> moving(count);
  std::iota(moving.begin(), moving.end(), 0);
  for (int step = 0; step < longest && !moving.empty(); ++step) {
    basis.append(nearby.solve(basis.residual(modes.eigenvalue, moving), ContactNodes::free));
    CyclicModes next = basis.lowest(count);
    next.residual = modes.eigenvalue.cwiseQuotient(next.eigenvalue).array() - 1.0;
    modes = std::move(next);
    std::erase_if(moving, [&](Eigen::Index mode) { return modes.residual[mode] < tolerance; });
  }
  if (moving.empty()) return modes;
  throw RunError("the modes of a nodal diameter could not be followed to this speed");
}

}  // namespace tiprub
