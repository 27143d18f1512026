// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/effects/coriolis.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/cells/cell_kind.h"
#include "postprocess/fields/cell_stress.h"
#include "reduce/model/dense_eigen.h"

namespace tiprub {

namespace {

constexpr int more_modes = 20;  // above the one asked for, that it couples with

/// [1] of a cell's volume, at its nodes: the integrals of the shape functions over the reference cell.
Eigen::VectorXd node_weights(const CellKind& kind) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(kind.nodes());
  for (const ReferencePoint& point : kind.integration) weights += point.weight * kind.shape(point.at);
  return weights / weights.sum();
}

}  // namespace

Eigen::VectorXd gyroscopic_frequencies(const Eigen::VectorXd& modes, const Eigen::MatrixXcd& coupling, double speed) {
  const Eigen::Index n = modes.size();
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(2 * n, 2 * n);
  matrix.topRightCorner(n, n).diagonal() = modes.cast<std::complex<double>>();
  matrix.bottomLeftCorner(n, n).diagonal() = modes.cast<std::complex<double>>();
  matrix.bottomRightCorner(n, n) = std::complex<double>(0, 2 * speed) * coupling;
  return eigenvalues(matrix);
}

Eigen::VectorXd node_volumes(const SectorFields& sector) {
  const Eigen::VectorXd cells = CellStress(sector).volumes();
  std::map<int, Eigen::VectorXd> weights;  // by number of nodes
  for (const CellKind& kind : all_cell_kinds()) weights[kind.nodes()] = node_weights(kind);
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(sector.nodes.cols());
  for (Eigen::Index cell = 0; cell < sector.cells.cols(); ++cell) {
    const auto nodes = nodes_of(sector.cells, cell);
    volumes(nodes) += cells[cell] * weights[static_cast<int>(nodes.size())];
  }
  return volumes;
}

Eigen::MatrixXcd coriolis_coupling(const Eigen::MatrixXcd& shapes, const Eigen::VectorXd& masses) {
  const Eigen::Index nodes = masses.size();
  const auto component = [&](Eigen::Index c) -> Eigen::MatrixXcd {
    return shapes(Eigen::seqN(c, nodes, Eigen::fix<3>), Eigen::all);
  };
  const Eigen::MatrixXcd r = component(0), theta = component(1);
  return theta.adjoint() * masses.asDiagonal() * r - r.adjoint() * masses.asDiagonal() * theta;
}

CoriolisTerms::CoriolisTerms(const FieldsReader& reader, const ReducedModel& model)
    : reader_(reader), model_(model), masses_(reader.sector().density * node_volumes(reader.sector())) {}

double CoriolisTerms::change(int nodal_diameter, int family, double speed) const {
  const NodalDiameterModel& matrices = model_.nodal_diameters[static_cast<std::size_t>(nodal_diameter)];
  const auto [squares, vectors] = eigenpairs(matrices.stiffness(speed), matrices.M);
  const Eigen::Index count = std::min<Eigen::Index>(family + 1 + more_modes, matrices.M.rows());
  // An unstable rotor's modes below zero have no frequency.
  const Eigen::VectorXd modes = squares.head(count).cwiseMax(0.0).cwiseSqrt();
  if (!(modes[family] > 0)) return 0.0;
  const Eigen::MatrixXcd shapes = reader_.expand(nodal_diameter, vectors.leftCols(count));
  const Eigen::VectorXd moved = gyroscopic_frequencies(modes, coriolis_coupling(shapes, masses_), speed);
  return std::max(std::abs(moved[count + family] / modes[family] - 1),
                  std::abs(-moved[count - 1 - family] / modes[family] - 1));
}

}  // namespace tiprub
