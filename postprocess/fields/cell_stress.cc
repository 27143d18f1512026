// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/cell_stress.h"

#include <cmath>
#include <map>
#include <string>

#include "cases/program/errors.h"
#include "cases/program/vector_lanes.h"
#include "mesh/cells/cell_kind.h"

namespace tiprub::postprocess {

namespace {

using Gradient = Eigen::Matrix<double, Eigen::Dynamic, 3>;  // of a cell's shape functions at one point

constexpr double flat = 1e-12;  // Jacobian determinant, of its norm cubed: rounding, far from the thinnest cell
constexpr std::size_t most_points = 27;
constexpr std::size_t interleaved = 4;  // real and imaginary parts of two displacements

/// A cell of CellStress. Matrices lie column after column.
struct CellInMemory {
  const int* node;
  int nodes, points;
  const double* gradient;     ///< [1/m] nodes x (3 directions of the first point, then of the second, ...)
  const double* from_points;  ///< [1] nodes x points
  double lambda, mu;          ///< [Pa]
};

/// Adds a cell's stress for four real displacements at once, which lie beside each other for each node and
/// component, of `displacement` and of `stress`. Cells are too small for products of a library.
TIPRUB_CLONES
void add_cell(const CellInMemory& cell, const double* displacement, double* stress) {
  Lanes4 at_points[most_points][6];
  for (int g = 0; g < cell.points; ++g) {
    const double* const gradient = cell.gradient + 3 * g * cell.nodes;
    Lanes4 slope[3][3] = {};  // of a component, in a direction
    for (int k = 0; k < cell.nodes; ++k)
      for (int of = 0; of < 3; ++of) {
        const Lanes4 moved = lanes4(displacement + interleaved * (3 * static_cast<std::size_t>(cell.node[k]) + of));
        for (int d = 0; d < 3; ++d) slope[of][d] += moved * gradient[d * cell.nodes + k];
      }
    const Lanes4 pressure = cell.lambda * (slope[0][0] + slope[1][1] + slope[2][2]);
    for (int d = 0; d < 3; ++d) {
      const int next = (d + 1) % 3;
      at_points[g][d] = pressure + 2 * cell.mu * slope[d][d];
      at_points[g][3 + d] = cell.mu * (slope[next][d] + slope[d][next]);
    }
  }
  for (int k = 0; k < cell.nodes; ++k) {
    double* const at_node = stress + interleaved * 6 * static_cast<std::size_t>(cell.node[k]);
    Lanes4 sum[6];
    for (int of = 0; of < 6; ++of) sum[of] = lanes4(at_node + interleaved * of);
    for (int g = 0; g < cell.points; ++g)
      for (int of = 0; of < 6; ++of) sum[of] += cell.from_points[g * cell.nodes + k] * at_points[g][of];
    for (int of = 0; of < 6; ++of) lanes4(at_node + interleaved * of) = sum[of];
  }
}

/// How complex numbers lie in memory.
using RealAndImaginary = Eigen::Matrix<double, 2, Eigen::Dynamic>;

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

std::array<ComplexTensors, 2> CellStress::sums(const Eigen::Matrix3Xcd& one, const Eigen::Matrix3Xcd& other) const {
  Eigen::Matrix<double, interleaved, Eigen::Dynamic> displacement(interleaved, one.size()),
      stress(interleaved, 2 * one.size());
  displacement << Eigen::Map<const RealAndImaginary>(reinterpret_cast<const double*>(one.data()), 2, one.size()),
      Eigen::Map<const RealAndImaginary>(reinterpret_cast<const double*>(other.data()), 2, other.size());
  stress.setZero();
  for (Eigen::Index cell = 0; cell < cells_.cols(); ++cell) {
    const auto nodes = nodes_of(cells_, cell);
    const Eigen::MatrixXd& gradient = gradient_[static_cast<std::size_t>(cell)];
    const int count = static_cast<int>(nodes.size());
    add_cell({nodes.data(), count, static_cast<int>(gradient.cols()) / 3, gradient.data(),
              cell_kind(count).stress_at_nodes.data(), lambda_, mu_},
             displacement.data(), stress.data());
  }
  std::array<ComplexTensors, 2> sums;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i].resize(6, one.cols());
    Eigen::Map<RealAndImaginary>(reinterpret_cast<double*>(sums[i].data()), 2, sums[i].size()) =
        stress.middleRows<2>(2 * static_cast<Eigen::Index>(i));
  }
  return sums;
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

ComplexTensors turned(const ComplexTensors& tensors, double angle) {
  return turning(angle) * tensors;
}

Tensors turned(const Tensors& tensors, double angle) {
  return turning(angle) * tensors;
}

}  // namespace tiprub::postprocess
