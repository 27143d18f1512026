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

/// One cell's stiffness and mass between cubic functions and nodes, for displacements in cylindrical components, all
/// by the same quadrature. Stiffness of nodes is in double precision, because they move far and strain little.
struct AddedCell {
  std::vector<int> functions;  ///< first dof of each cubic function that moves: r; theta and z follow
  std::vector<int> nodes;      ///< first sector dof of each node, or -1
  Eigen::MatrixXf stiffness;   ///< [N/m] cubic x cubic dofs
  Eigen::MatrixXd coupling;    ///< [N/m] cubic x node dofs
  Eigen::MatrixXd of_nodes;    ///< [N/m] node x node dofs
  Eigen::MatrixXf mass;        ///< [kg] (cubic, then node dofs) x node dofs
};

/// What quadratic cells lack: cubic functions of their edges, and functions of their faces and of bricks that vanish
/// around them. With the linear functions N_a of the corners a, b, c, ... around,
///     edge          4 N_a N_b (N_b - N_a)/s^2,   x (1 - x^2) along it,
///     triangle      27 N_a N_b N_c/s^2,
///     quadrangle    16 N_a N_c/s,                (1 - x^2)(1 - y^2) on it,
///     brick         64 N_a N_g of opposite corners, likewise.
/// s is 1 on triangles; where a cell goes on beyond an edge or face by quadrangles, s falls linearly over them, from
/// 1 to 0 at the other end, and the function with it. A brick of 27 nodes has the last two already; they are replaced
/// by themselves times x, y and z. Without these, displacements near a point force would hardly be richer. So
/// neighbours of any kind have the same functions on a face that they share, unless one has a node in its middle.
/// With them a straight cell holds all polynomials of the third degree (except a pyramid, which has rational
/// functions). All vanish at the nodes. They are numbered as the nodes are (see SectorDofs), interior | low cut face
/// | high cut face, in the cylindrical frame at the middle of the edge, face or cell, so that a CyclicTransformation
/// applies.
class AddedFunctions {
 public:
  /// A function on a face.
  struct OfFace {
    /// Corners from which and to which it goes, if it is odd along an axis: from the side with the lowest number on.
    std::array<std::vector<int>, 2> sides;
    /// The edges, k from corner k to k + 1, that it is known by: those along its axis, or all of the face. Their
    /// middles, ascending, are its key.
    std::vector<int> edges;
  };
  /// The functions on a face of so many nodes (see face_shape()).
  static std::vector<OfFace> of_face(int nodes);
  /// Their values, likewise.
  static std::vector<double> on_face(int nodes, double s, double t);

  /// Not for cubic displacements, nor where bricks of 27 nodes have neighbours of another kind, nor where the cells
  /// divide the cuts differently.
  static bool serve(const SectorMesh& mesh);
  /// [bytes] of the AddedCells of a mesh.
  static double memory(const SectorMesh& mesh);

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

  void number(const std::vector<std::vector<int>>& middles);

  const SectorMesh& mesh_;
  SectorDofs dofs_;
  std::vector<int> lower_;  ///< of each node of the high cut face, its partner; -1 of the others
  std::vector<Function> functions_;
  std::map<std::vector<int>, int> numbers_;  ///< of functions, by their keys (see OfFace)
  std::vector<std::vector<InCell>> cells_;
};

}  // namespace tiprub::reduce
