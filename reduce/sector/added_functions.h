// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <map>
#include <vector>

#include "reduce/sector/rotating_elasticity.h"
#include "reduce/sector/sector_dofs.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// One cell's stiffness and mass between cubic functions and nodes, for displacements in cylindrical components.
/// Stiffness is in double precision, because nodes move far and strain little.
struct AddedCell {
  std::vector<int> functions;  ///< first dof of each cubic function that moves: r; theta and z follow
  std::vector<int> nodes;      ///< first sector dof of each node, or -1
  Eigen::MatrixXd stiffness;   ///< [N/m] cubic x cubic dofs
  Eigen::MatrixXd coupling;    ///< [N/m] cubic x node dofs
  Eigen::MatrixXd of_nodes;    ///< [N/m] node x node dofs
  Eigen::MatrixXf mass;        ///< [kg] cubic x node dofs
};

/// What a brick of 20 nodes lacks: cubic functions of its edges, quadratic ones in the middles of its faces and in
/// its middle. With the bubbles b2 = 1 - x^2 and b3 = x (1 - x^2) of each direction of the reference cell,
///     edge      b3 along it, linear across,
///     face      b2 b2 on it, linear across,
///     middle    b2 b2 b2.
/// With them a brick holds all polynomials of the third degree, and those of the brick of 27 nodes. All vanish at the
/// nodes. They are numbered as the nodes are (see SectorDofs), interior | low cut face | high cut face, in the
/// cylindrical frame at the middle of the edge or face, so that a CyclicTransformation applies.
class AddedFunctions {
 public:
  static constexpr int on_a_face = 5;
  /// The functions that a brick has on a face: those of the edges from corner k to k + 1, then that of the face.
  static std::array<double, on_a_face> on_face(double s, double t);

  /// Whether all cells are bricks of 20 nodes with quadratic displacements.
  static bool serve(const SectorMesh& mesh);

  /// The mesh must outlive this object.
  explicit AddedFunctions(const SectorMesh& mesh);

  /// Numbers of dofs on cut faces and elsewhere; nodes and contact are empty.
  const SectorDofs& dofs() const { return dofs_; }
  /// B of unit forces on so many contact unknowns, r, theta, z of each (see SectorDofs), from their added weights
  /// (see ContactUnknowns). A force at a node doesn't load cubic functions.
  Eigen::MatrixXd contact_loads(const std::map<std::vector<int>, Eigen::VectorXd>& weights, int contacts) const;
  AddedCell integrate(int cell, const SectorDofs& node_dofs, const Material& material) const;

 private:
  struct Function {
    int first = -1;  ///< dof; -1 if it doesn't move
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  };
  struct InCell {
    int function = 0;
    double sign = 1;  ///< of an edge that the cell has against the function's direction
  };

  void number();

  const SectorMesh& mesh_;
  SectorDofs dofs_;
  std::vector<int> lower_;  ///< of each node of the high cut face, its partner; -1 of the others
  std::vector<Function> functions_;
  std::map<std::vector<int>, int> numbers_;  ///< of functions, by the nodes in the middles of their edges, ascending
  std::vector<std::vector<InCell>> cells_;
};

}  // namespace tiprub::reduce
