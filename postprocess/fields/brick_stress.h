// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <vector>

#include "reduce/model/fields_file.h"

namespace tiprub {

/// Symmetric tensors at nodes: xx, yy, zz, xy, yz, zx; one a column.
using Tensors = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using ComplexTensors = Eigen::Matrix<std::complex<double>, 6, Eigen::Dynamic>;

/// Where VTK's nodes of a quadratic hexahedron sit in [-1, 1]^3: corners, mid-sides, face centres, centre.
const std::array<std::array<int, 3>, 27>& brick_reference_nodes();

/// Stress at the nodes of a sector by linear elasticity, sigma = lambda tr(eps) I + 2 mu eps. Strains are taken at
/// the 2 x 2 x 2 Gauss points of each brick, where those of quadratic bricks are exact to one order more (Barlow
/// 1976), carried on to its nodes trilinearly (Hinton and Campbell 1974), and averaged over the bricks that share a
/// node. Strains at the nodes themselves would be of the same order, and several times as wrong.
///
/// The shape functions of the 20- and 27-node brick are written out here: the sector's operators take theirs from
/// deal.II, which has no 20-node brick (reduce/sector) and would make this program start in seconds, and the mesher's
/// (mesh/lattice) belong to another room. The tests hold them to constant and to linear stress, exactly.
class BrickStress {
 public:
  explicit BrickStress(const SectorFields& sector);

  /// [Pa] of a displacement [m] in x, y, z: sums over the bricks at each node.
  Tensors sum(const Eigen::Matrix3Xd& displacement) const;
  /// How many bricks each node has.
  const Eigen::VectorXi& bricks_at_node() const { return bricks_; }
  /// [Pa] averages over the bricks of the sector alone.
  Tensors average(const Eigen::Matrix3Xd& displacement) const;
  /// [m^3] by brick.
  const Eigen::VectorXd& volumes() const { return volumes_; }
  /// The first brick that is flat or turned inside out at a Gauss point, where it has no strain; none in a sound
  /// mesh.
  const std::optional<Eigen::Index>& degenerate_cell() const { return degenerate_; }

 private:
  using Gradient = Eigen::Matrix<double, Eigen::Dynamic, 3>;  // of a brick's shape functions at one point [1/m]
  const Eigen::MatrixXi& cells_;
  double lambda_, mu_;
  Eigen::MatrixXd to_nodes_;                       // nodes of a brick x Gauss points
  std::vector<std::array<Gradient, 8>> gradient_;  // by cell, then Gauss point
  Eigen::VectorXi bricks_;
  Eigen::VectorXd volumes_;
  std::optional<Eigen::Index> degenerate_;
};

/// [Pa]
Eigen::VectorXd von_mises(const Tensors& stress);

/// Tensors of a body that is turned about z by an angle [rad]: R sigma R'.
ComplexTensors turned(const ComplexTensors& tensors, double angle);
Tensors turned(const Tensors& tensors, double angle);

}  // namespace tiprub
