// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <string>
#include <vector>

namespace tiprub {

/// A point of a reference cell, with its weight in a quadrature.
struct ReferencePoint {
  Eigen::Vector3d at;
  double weight = 0;
};

/// A quadratic solid element: tet10, pyramid13, wedge15, hex20 or hex27, known by its number of nodes. Its nodes and
/// a list of monomials x^i y^j z^k determine its shape functions: N(x) = V^-T m(x), V_ab = m_b(x_a).
///
/// Reference cells: tetrahedron x, y, z >= 0, x + y + z <= 1; wedge x, y >= 0, x + y <= 1, |z| <= 1; brick [-1, 1]^3;
/// pyramid |x|, |y| <= -z, -1 <= z <= 0, with its apex at z = 0 (there rational functions, Bedrosian 1992).
///
/// Integration is that of CalculiX's C3D10 (4 points), C3D15 (9) and C3D20 (27): with rules of the second degree the
/// frequencies of straight quadratic cells keep their order of convergence (Strang and Fix 1973, section 4.3).
struct CellKind {
  std::string name;  ///< "hex20"
  int gmsh_type = 0, vtk_type = 0;
  std::string calculix;                       ///< "C3D20"; empty where CalculiX has no such element
  int corners = 0;                            ///< the first nodes are the corners
  std::vector<Eigen::Vector3d> places;        ///< of its nodes in the reference cell, in VTK's order
  std::vector<std::array<int, 2>> edges;      ///< corners at the ends of edge e; node `corners` + e is its middle
  std::vector<std::vector<int>> faces;        ///< corners around, seen from outside
  std::vector<int> gmsh_node;                 ///< where VTK's node k stands in gmsh's order
  std::vector<ReferencePoint> integration;    ///< of stiffness, mass and loads
  std::vector<ReferencePoint> stress_points;  ///< where strains are exact to one order more (Barlow 1976)
  Eigen::MatrixXd stress_at_nodes;  ///< [1] extrapolates from these points to the nodes by the lowest polynomials
  std::vector<Eigen::Vector3d> upright_at;  ///< where, besides the integration points, a cell must not be inverted

  /// The node in the middle of the edge between two corners.
  int middle_of(int corner, int other) const;
  int nodes() const { return static_cast<int>(places.size()); }
  /// [1] of its shape functions.
  Eigen::VectorXd shape(const Eigen::Vector3d& at) const;
  /// [1] nodes x 3, in the reference cell.
  Eigen::MatrixX3d gradient(const Eigen::Vector3d& at) const;

  std::vector<std::array<int, 3>> monomials;  ///< exponents
  Eigen::MatrixXd coefficients;               ///< V^-T
};

/// The kind with this number of nodes: 10, 13, 15, 20 or 27. `all_cell_kinds` lists them.
const CellKind& cell_kind(int nodes);
const std::vector<CellKind>& all_cell_kinds();
bool is_cell_kind(int nodes);
/// "10, 13, 15, 20 or 27", for messages.
std::string cell_node_counts();

/// The nodes of a cell or of a face. A column lists them first and is filled up with -1.
inline auto nodes_of(const Eigen::MatrixXi& cells, Eigen::Index cell) {
  Eigen::Index count = cells.rows();
  while (count > 0 && cells(count - 1, cell) < 0) --count;
  return cells.col(cell).head(count);
}

/// Shape functions of a face of 6, 8 or 9 nodes (corners around, mid-sides, centre) at (s, t), and d/ds, d/dt: nodes
/// x 3. Triangles: s, t >= 0, s + t <= 1; quadrangles: [-1, 1]^2.
Eigen::MatrixX3d face_shape(int nodes, double s, double t);

}  // namespace tiprub
