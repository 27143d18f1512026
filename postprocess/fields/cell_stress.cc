// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/cell_stress.h"

#include <array>
#include <cmath>
#include <map>
#include <string>

#include "cases/program/errors.h"
#include "mesh/cells/cell_kind.h"

namespace tiprub::postprocess {

namespace {

using Gradient = Eigen::Matrix<double, Eigen::Dynamic, 3>;  // of a cell's shape functions at one point

constexpr double flat = 1e-12;  // Jacobian determinant, of its norm cubed: rounding, far from the thinnest cell
constexpr std::size_t most_points = 27;

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
    Eigen::MatrixXd& gradient = gradient_[static_cast<std::size_t>(cell)];
    gradient.resize(nodes.size(), 3 * static_cast<Eigen::Index>(reference.size()));
    for (std::size_t g = 0; g < reference.size(); ++g) {
      const Eigen::Matrix3d jacobian = place * reference[g];  // dx/dxi
      gradient.middleCols<3>(3 * static_cast<Eigen::Index>(g)) = reference[g] * jacobian.inverse();
      volumes_[cell] += kind.stress_points[g].weight * jacobian.determinant();
      const bool sound = jacobian.determinant() > flat * std::pow(jacobian.norm(), 3);
      if (!sound && !degenerate_) degenerate_ = cell;
    }
  }
}

/// Adds the stress of `parts` displacements at once: one real field, or real and imaginary part, which lie side by
/// side in memory. Cells are too small for Eigen's blocked products.
template <int parts>
void CellStress::add_cells(const double* displacement, double* stress) const {
  using Moved = Eigen::Vector<double, 3 * parts>;
  using Stress = Eigen::Vector<double, 6 * parts>;
  std::array<Stress, most_points> at_points;
  for (Eigen::Index cell = 0; cell < cells_.cols(); ++cell) {
    const auto nodes = nodes_of(cells_, cell);
    const Eigen::MatrixXd& gradient = gradient_[static_cast<std::size_t>(cell)];
    const Eigen::Index count = gradient.cols() / 3;
    for (Eigen::Index g = 0; g < count; ++g) {
      std::array<Moved, 3> slope = {Moved::Zero(), Moved::Zero(), Moved::Zero()};
      for (Eigen::Index k = 0; k < nodes.size(); ++k) {
        const Eigen::Map<const Moved> moved(displacement + 3 * parts * nodes[k]);
        for (int d = 0; d < 3; ++d) slope[d] += gradient(k, 3 * g + d) * moved;
      }
      const auto by = [&](int of, int d) { return slope[d].template segment<parts>(of * parts); };
      const Eigen::Vector<double, parts> pressure = lambda_ * (by(0, 0) + by(1, 1) + by(2, 2));
      for (int d = 0; d < 3; ++d) {
        const int next = (d + 1) % 3;
        at_points[g].template segment<parts>(d * parts) = pressure + 2 * mu_ * by(d, d);
        at_points[g].template segment<parts>((3 + d) * parts) = mu_ * (by(d, next) + by(next, d));
      }
    }
    const Eigen::MatrixXd& to_nodes = cell_kind(static_cast<int>(nodes.size())).stress_at_nodes;
    for (Eigen::Index k = 0; k < nodes.size(); ++k) {
      Eigen::Map<Stress> sum(stress + 6 * parts * nodes[k]);
      Stress here = sum;
      for (Eigen::Index g = 0; g < count; ++g) here += to_nodes(k, g) * at_points[g];
      sum = here;
    }
  }
}

Tensors CellStress::sum(const Eigen::Matrix3Xd& displacement) const {
  Tensors stress = Tensors::Zero(6, displacement.cols());
  add_cells<1>(displacement.data(), stress.data());
  return stress;
}

ComplexTensors CellStress::sum(const Eigen::Matrix3Xcd& displacement) const {
  ComplexTensors stress = ComplexTensors::Zero(6, displacement.cols());
  add_cells<2>(reinterpret_cast<const double*>(displacement.data()), reinterpret_cast<double*>(stress.data()));
  return stress;
}

Tensors CellStress::average(const Eigen::Matrix3Xd& displacement) const {
  return sum(displacement).array().rowwise() / cells_at_node_.transpose().cast<double>().array();
}

CellStress sound_cells(const FieldsReader& reader) {
  CellStress cells(reader.sector());
  if (const auto& cell = cells.degenerate_cell())
    throw InputError(reader.path() + ": /cells: cell " + std::to_string(*cell) +
                     " is flat or turned inside out; it has no stress. Look at the mesh, and at the order of its "
                     "nodes");
  return cells;
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

}  // namespace tiprub::postprocess
