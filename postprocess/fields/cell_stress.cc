// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/cell_stress.h"

#include <cmath>
#include <map>

#include "mesh/cells/cell_kind.h"

namespace tiprub {

namespace {

constexpr double flat = 1e-12;  // Jacobian determinant, of its norm cubed: rounding, far from the thinnest cell

}  // namespace

CellStress::CellStress(const SectorFields& sector)
    : cells_(sector.cells),
      lambda_(sector.young * sector.poisson / ((1 + sector.poisson) * (1 - 2 * sector.poisson))),
      mu_(sector.young / (2 * (1 + sector.poisson))),
      gradient_(static_cast<std::size_t>(sector.cells.cols())),
      cells_at_node_(Eigen::VectorXi::Zero(sector.nodes.cols())),
      volumes_(Eigen::VectorXd::Zero(sector.cells.cols())) {
  std::map<int, std::vector<Gradient>> references;  // by number of nodes, then point
  for (const CellKind& kind : all_cell_kinds())
    for (const ReferencePoint& point : kind.stress_points)
      references[kind.nodes()].push_back(kind.gradient(point.at));
  for (Eigen::Index cell = 0; cell < cells_.cols(); ++cell) {
    const auto nodes = nodes_of(cells_, cell);
    for (const int node : nodes) ++cells_at_node_[node];
    const Eigen::Matrix3Xd place = sector.nodes(Eigen::all, nodes);
    const CellKind& kind = cell_kind(static_cast<int>(nodes.size()));
    const std::vector<Gradient>& reference = references[kind.nodes()];
    for (std::size_t g = 0; g < reference.size(); ++g) {
      const Eigen::Matrix3d jacobian = place * reference[g];  // dx/dxi
      gradient_[static_cast<std::size_t>(cell)].emplace_back(reference[g] * jacobian.inverse());
      volumes_[cell] += kind.stress_points[g].weight * jacobian.determinant();
      const bool sound = jacobian.determinant() > flat * std::pow(jacobian.norm(), 3);
      if (!sound && !degenerate_) degenerate_ = cell;
    }
  }
}

Tensors CellStress::sum(const Eigen::Matrix3Xd& displacement) const {
  Tensors stress = Tensors::Zero(6, displacement.cols());
  Eigen::Matrix<double, 6, Eigen::Dynamic> at_points;
  for (Eigen::Index cell = 0; cell < cells_.cols(); ++cell) {
    const auto nodes = nodes_of(cells_, cell);
    const Eigen::Matrix3Xd moved = displacement(Eigen::all, nodes);
    const std::vector<Gradient>& gradients = gradient_[static_cast<std::size_t>(cell)];
    at_points.resize(6, static_cast<Eigen::Index>(gradients.size()));
    for (Eigen::Index g = 0; g < at_points.cols(); ++g) {
      const Eigen::Matrix3d slope = moved * gradients[static_cast<std::size_t>(g)];
      const double pressure = lambda_ * slope.trace();
      at_points.col(g) << pressure + 2 * mu_ * slope(0, 0), pressure + 2 * mu_ * slope(1, 1),
          pressure + 2 * mu_ * slope(2, 2), mu_ * (slope(0, 1) + slope(1, 0)), mu_ * (slope(1, 2) + slope(2, 1)),
          mu_ * (slope(2, 0) + slope(0, 2));
    }
    const Eigen::Matrix<double, 6, Eigen::Dynamic> at_nodes =
        at_points * cell_kind(static_cast<int>(nodes.size())).stress_at_nodes.transpose();
    for (Eigen::Index k = 0; k < nodes.size(); ++k) stress.col(nodes[k]) += at_nodes.col(k);
  }
  return stress;
}

Tensors CellStress::average(const Eigen::Matrix3Xd& displacement) const {
  return sum(displacement).array().rowwise() / cells_at_node_.transpose().cast<double>().array();
}

Eigen::VectorXd von_mises(const Tensors& stress) {
  const auto s = stress.array();
  return (0.5 * ((s.row(0) - s.row(1)).square() + (s.row(1) - s.row(2)).square() + (s.row(2) - s.row(0)).square()) +
          3 * (s.row(3).square() + s.row(4).square() + s.row(5).square()))
      .sqrt()
      .transpose();
}

namespace {

/// R sigma R' on the six components; R turns x towards y.
Eigen::Matrix<double, 6, 6> turning(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  matrix.row(0) << c * c, s * s, 0, -2 * c * s, 0, 0;
  matrix.row(1) << s * s, c * c, 0, 2 * c * s, 0, 0;
  matrix(2, 2) = 1;
  matrix.row(3) << c * s, -c * s, 0, c * c - s * s, 0, 0;
  matrix.row(4) << 0, 0, 0, 0, c, s;
  matrix.row(5) << 0, 0, 0, 0, -s, c;
  return matrix;
}

}  // namespace

ComplexTensors turned(const ComplexTensors& tensors, double angle) {
  return turning(angle) * tensors;
}

Tensors turned(const Tensors& tensors, double angle) {
  return turning(angle) * tensors;
}

}  // namespace tiprub
