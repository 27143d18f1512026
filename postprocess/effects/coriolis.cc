// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/effects/coriolis.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "postprocess/fields/brick_stress.h"

namespace tiprub {

namespace {

constexpr int more_modes = 20;  // above the one asked for, that it couples with

/// [1] of a brick's volume, at its node k: the integral of the shape function over the cube.
double node_weight(Eigen::Index nodes, std::size_t k) {
  constexpr Eigen::Index serendipity = 20;
  if (nodes == serendipity) return k < 8 ? -1.0 / 8 : 1.0 / 6;
  double weight = 1;  // Simpson's, in each direction
  for (const int place : brick_reference_nodes()[k]) weight *= place == 0 ? 2.0 / 3 : 1.0 / 6;
  return weight;
}

}  // namespace

Eigen::VectorXd gyroscopic_frequencies(const Eigen::VectorXd& modes, const Eigen::MatrixXcd& coupling, double speed) {
  const Eigen::Index n = modes.size();
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(2 * n, 2 * n);
  matrix.topRightCorner(n, n).diagonal() = modes.cast<std::complex<double>>();
  matrix.bottomLeftCorner(n, n).diagonal() = modes.cast<std::complex<double>>();
  matrix.bottomRightCorner(n, n) = std::complex<double>(0, 2 * speed) * coupling;
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::VectorXd node_volumes(const SectorFields& sector) {
  const Eigen::VectorXd bricks = BrickStress(sector).volumes();
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(sector.nodes.cols());
  for (Eigen::Index cell = 0; cell < sector.cells.cols(); ++cell)
    for (Eigen::Index k = 0; k < sector.cells.rows(); ++k)
      volumes[sector.cells(k, cell)] += bricks[cell] * node_weight(sector.cells.rows(), static_cast<std::size_t>(k));
  return volumes;
}

Eigen::MatrixXcd coriolis_coupling(const Eigen::MatrixXcd& shapes, const Eigen::VectorXd& volumes) {
  const Eigen::Index nodes = volumes.size();
  const auto component = [&](Eigen::Index c) -> Eigen::MatrixXcd {
    return shapes(Eigen::seqN(c, nodes, Eigen::fix<3>), Eigen::all);
  };
  const Eigen::MatrixXcd r = component(0), theta = component(1), z = component(2);
  const auto weight = volumes.asDiagonal();
  const Eigen::VectorXd mass =
      (r.adjoint() * weight * r + theta.adjoint() * weight * theta + z.adjoint() * weight * z).diagonal().real();
  const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXcd coupling = theta.adjoint() * weight * r - r.adjoint() * weight * theta;
  return scale.asDiagonal() * coupling * scale.asDiagonal();
}

CoriolisTerms::CoriolisTerms(const FieldsReader& reader, const ReducedModel& model)
    : reader_(reader), model_(model), volumes_(node_volumes(reader.sector())) {}

double CoriolisTerms::change(int nodal_diameter, int family, double speed) const {
  const NodalDiameterModel& matrices = model_.nodal_diameters[static_cast<std::size_t>(nodal_diameter)];
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> solver(matrices.stiffness(speed), matrices.M);
  const Eigen::Index count = std::min<Eigen::Index>(family + 1 + more_modes, matrices.M.rows());
  // An unstable rotor's modes below zero have no frequency.
  const Eigen::VectorXd modes = solver.eigenvalues().head(count).cwiseMax(0.0).cwiseSqrt();
  if (!(modes[family] > 0)) return 0.0;
  const Eigen::MatrixXcd shapes = reader_.expand(nodal_diameter, solver.eigenvectors().leftCols(count));
  const Eigen::VectorXd moved = gyroscopic_frequencies(modes, coriolis_coupling(shapes, volumes_), speed);
  return std::max(std::abs(moved[count + family] / modes[family] - 1),
                  std::abs(-moved[count - 1 - family] / modes[family] - 1));
}

}  // namespace tiprub
