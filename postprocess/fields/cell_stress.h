// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <vector>

#include "reduce/model/fields_file.h"

namespace tiprub::postprocess {

/// Symmetric tensors at nodes, a column each: xx, yy, zz, xy, yz, zx.
using Tensors = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using ComplexTensors = Eigen::Matrix<std::complex<double>, 6, Eigen::Dynamic>;

/// Stress at the nodes of a sector by linear elasticity, sigma = lambda tr(eps) I + 2 mu eps. Strains are computed at
/// the superconvergent points of each cell (the 2 x 2 x 2 Gauss points of a brick: Barlow 1976), extrapolated to its
/// nodes by the lowest polynomials through them (trilinear in a brick: Hinton and Campbell 1974), and averaged over
/// the cells that share a node. Strains computed at the nodes directly would have errors several times as large.
class CellStress {
 public:
  explicit CellStress(const SectorFields& sector);

  /// [Pa] The stress of two displacements [m] in x, y, z, summed over the cells at each node.
  std::array<ComplexTensors, 2> sums(const Eigen::Matrix3Xcd& one, const Eigen::Matrix3Xcd& other) const;
  /// How many cells each node has.
  const Eigen::VectorXi& cells_at_node() const { return cells_at_node_; }
  /// [m^3] by cell.
  const Eigen::VectorXd& volumes() const { return volumes_; }
  /// The first cell that is flat or turned inside out, so that it has no strain; none in a sound mesh.
  const std::optional<Eigen::Index>& degenerate_cell() const { return degenerate_; }

 private:
  const Eigen::MatrixXi& cells_;
  double lambda_, mu_;
  /// [1/m] By cell: gradients of its shape functions in x, y, z at the first point, the second, ...; nodes x columns.
  std::vector<Eigen::MatrixXd> gradient_;
  Eigen::VectorXi cells_at_node_;
  Eigen::VectorXd volumes_;
  std::optional<Eigen::Index> degenerate_;
};

/// That of the cells of full fields. Raises InputError if a cell has none.
CellStress sound_cells(const FieldsReader& reader);

/// [Pa]
Eigen::VectorXd von_mises(const Tensors& stress);

/// Tensors of a body that is turned about z by an angle [rad]: R sigma R'.
ComplexTensors turned(const ComplexTensors& tensors, double angle);
Tensors turned(const Tensors& tensors, double angle);

}  // namespace tiprub::postprocess
