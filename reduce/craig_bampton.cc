// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/craig_bampton.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace tiprub {

namespace {

constexpr double dependence_tolerance = 1e-10;  // of a unit direction, in squared stiffness norm

Eigen::MatrixXcd collect(const std::vector<SpeedShapes>& speeds) {
  const SpeedShapes& rest = speeds.front();
  Eigen::MatrixXcd all = rest.fixed_interface_modes;
  for (std::size_t s = 1; s < speeds.size(); ++s) {
    const Eigen::Index old = all.cols(), modes = speeds[s].fixed_interface_modes.cols();
    all.conservativeResize(Eigen::NoChange, old + modes + rest.constraint_modes.cols());
    all.middleCols(old, modes) = speeds[s].fixed_interface_modes;
    all.rightCols(rest.constraint_modes.cols()) = speeds[s].constraint_modes - rest.constraint_modes;
  }
  return all;
}

}  // namespace

Eigen::MatrixXcd project(const TravellingWave& wave, const SymmetricMatrix& matrix, const Eigen::MatrixXcd& basis) {
  const Eigen::MatrixXcd product = basis.adjoint() * wave.apply(matrix, basis);
  return 0.5 * (product + product.adjoint());
}

CraigBamptonBasis merge_speeds(const TravellingWave& wave, const std::vector<SpeedShapes>& speeds,
                               const SymmetricMatrix& stiffness, const SymmetricMatrix& mass) {
  Eigen::MatrixXcd inner = collect(speeds);
  Eigen::MatrixXcd gram = project(wave, stiffness, inner);
  const Eigen::VectorXd scale = gram.diagonal().real().unaryExpr(
      [](double square) { return square > 0 ? 1 / std::sqrt(square) : 0.0; });  // 0: speed changed nothing
  gram = scale.asDiagonal() * gram * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> directions(gram);
  const Eigen::VectorXd& lengths = directions.eigenvalues();
  const Eigen::Index kept = (lengths.array() > dependence_tolerance * lengths[lengths.size() - 1]).count();
  const Eigen::MatrixXcd independent = scale.asDiagonal() * directions.eigenvectors().rightCols(kept) *
                                       lengths.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  inner = inner * independent;  // now K-orthonormal
  // Modes of the small model with contact nodes held: M z = z / omega^2, largest last.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> modes(project(wave, mass, inner));
  const Eigen::MatrixXcd ascending = modes.eigenvectors().rowwise().reverse();
  const Eigen::VectorXd norms = modes.eigenvalues().reverse().cwiseSqrt();
  CraigBamptonBasis basis;
  basis.dropped = static_cast<int>(lengths.size() - kept);
  const Eigen::MatrixXcd& constraint = speeds.front().constraint_modes;
  basis.shapes.resize(inner.rows(), constraint.cols() + kept);
  basis.shapes << constraint, inner * ascending * norms.cwiseInverse().asDiagonal();
  return basis;
}

}  // namespace tiprub
