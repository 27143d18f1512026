// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cells/cell_kind.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "mesh/cells/gauss_points.h"

namespace tiprub {

namespace {

using Exponents = std::array<int, 3>;

std::vector<ReferencePoint> brick_points(int line) {
  std::vector<ReferencePoint> points;
  for (const auto& [z, wz] : gauss_points(line))
    for (const auto& [y, wy] : gauss_points(line))
      for (const auto& [x, wx] : gauss_points(line)) points.push_back({{x, y, z}, wx * wy * wz});
  return points;
}

/// Exact to the second degree.
std::vector<ReferencePoint> tetrahedron_points() {
  const double a = (5 - std::sqrt(5.0)) / 20, b = 1 - 3 * a;
  std::vector<ReferencePoint> points;
  for (const Eigen::Vector3d& at : {Eigen::Vector3d(a, a, a), {b, a, a}, {a, b, a}, {a, a, b}})
    points.push_back({at, 1.0 / 24});
  return points;
}

std::vector<ReferencePoint> wedge_points(int line) {
  std::vector<ReferencePoint> points;
  for (const auto& [z, weight] : gauss_points(line))
    for (const auto& [x, y] : {std::array{1 / 6.0, 1 / 6.0}, {2 / 3.0, 1 / 6.0}, {1 / 6.0, 2 / 3.0}})
      points.push_back({{x, y, z}, weight / 6});
  return points;
}

/// The points of a brick, drawn together at the apex.
std::vector<ReferencePoint> pyramid_points(int across, int along) {
  std::vector<ReferencePoint> points;
  for (const auto& [c, wc] : gauss_points(along)) {
    const double r = (1 + c) / 2;
    for (const auto& [b, wb] : gauss_points(across))
      for (const auto& [a, wa] : gauss_points(across))
        points.push_back({{r * a, r * b, -r}, wa * wb * wc / 2 * r * r});
  }
  return points;
}

/// x^i; 1 for i = 0, even if x = 0.
double power(double x, int exponent) {
  double value = 1;
  for (int i = 0; i < std::abs(exponent); ++i) value *= x;
  return exponent >= 0 ? value : 1 / value;
}

double monomial(const Exponents& exponents, const Eigen::Vector3d& at) {
  const double across = power(at[0], exponents[0]) * power(at[1], exponents[1]);
  return across == 0 ? 0 : across * power(at[2], exponents[2]);
}

/// The monomials that a kind has, with exponents 0 to 2 and, for a pyramid, also 1/z.
std::vector<Exponents> chosen(const std::function<bool(int, int, int)>& has) {
  std::vector<Exponents> monomials;
  for (int k = -1; k <= 2; ++k)
    for (int j = 0; j <= 2; ++j)
      for (int i = 0; i <= 2; ++i)
        if (has(i, j, k)) monomials.push_back({i, j, k});
  return monomials;
}

Eigen::MatrixXd values(const std::vector<Exponents>& monomials, const std::vector<Eigen::Vector3d>& places) {
  Eigen::MatrixXd matrix(places.size(), monomials.size());
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = 0; b < monomials.size(); ++b)
      matrix(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = monomial(monomials[b], places[a]);
  return matrix;
}

/// Adds the mid-side nodes and all that follows from nodes and monomials. `smooth` are the monomials of the stress.
CellKind completed(CellKind kind, const std::vector<Exponents>& smooth) {
  kind.corners = static_cast<int>(kind.places.size());
  for (const auto& [a, b] : kind.edges) kind.places.push_back((kind.places[a] + kind.places[b]) / 2);
  if (kind.gmsh_node.size() > kind.places.size()) {  // hex27
    for (const std::vector<int>& face : kind.faces) {
      kind.places.emplace_back(0, 0, 0);
      for (const int corner : face) kind.places.back() += kind.places[corner] / 4;
    }
    kind.places.emplace_back(0, 0, 0);
  }
  kind.coefficients = values(kind.monomials, kind.places).inverse().transpose();
  std::vector<Eigen::Vector3d> points;
  for (const ReferencePoint& point : kind.stress_points) points.push_back(point.at);
  const Eigen::MatrixXd fit = values(smooth, points).completeOrthogonalDecomposition().pseudoInverse();
  kind.stress_at_nodes = values(smooth, kind.places) * fit;
  kind.upright_at = kind.places;
  return kind;
}

CellKind named(const char* name, int gmsh_type, int vtk_type, const char* calculix) {
  CellKind kind;
  kind.name = name;
  kind.gmsh_type = gmsh_type;
  kind.vtk_type = vtk_type;
  kind.calculix = calculix;
  return kind;
}

CellKind tet10() {
  CellKind kind = named("tet10", 11, 24, "C3D10");
  kind.places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  kind.edges = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  kind.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  kind.gmsh_node = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
  kind.integration = kind.stress_points = tetrahedron_points();
  kind.monomials = chosen([](int i, int j, int k) { return k >= 0 && i + j + k <= 2; });
  return completed(kind, chosen([](int i, int j, int k) { return k >= 0 && i + j + k <= 1; }));
}

CellKind wedge15() {
  CellKind kind = named("wedge15", 18, 26, "C3D15");
  kind.places = {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  kind.edges = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
  kind.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  kind.gmsh_node = {0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11};
  kind.integration = wedge_points(3);
  kind.stress_points = wedge_points(2);
  kind.monomials = chosen([](int i, int j, int k) { return k >= 0 && i + j <= (k == 2 ? 1 : 2); });
  return completed(kind, chosen([](int i, int j, int k) { return k >= 0 && k <= 1 && i + j <= 1; }));
}

CellKind pyramid13() {
  CellKind kind = named("pyramid13", 19, 27, "");
  kind.places = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {0, 0, 0}};
  kind.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
  kind.faces = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  kind.gmsh_node = {0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12};
  kind.integration = pyramid_points(3, 4);
  kind.stress_points = pyramid_points(2, 2);
  kind.monomials = chosen([](int i, int j, int k) { return k >= 0 ? i + j + k <= 2 : i > 0 && j > 0 && i + j <= 3; });
  kind = completed(kind, chosen([](int i, int j, int k) { return k >= 0 && i + j + k <= 1; }));
  kind.upright_at.erase(kind.upright_at.begin() + 4);  // at the apex slopes depend on the direction
  return kind;
}

CellKind brick(CellKind kind) {
  kind.places = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  kind.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  kind.faces = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  kind.integration = brick_points(3);
  kind.stress_points = brick_points(2);
  return completed(kind, chosen([](int i, int j, int k) { return k >= 0 && std::max({i, j, k}) <= 1; }));
}

CellKind hex27() {
  CellKind kind = named("hex27", 12, 29, "");
  kind.gmsh_node = {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15, 22, 23, 21, 24, 20, 25, 26};
  kind.monomials = chosen([](int, int, int k) { return k >= 0; });
  return brick(kind);
}

/// In the degree of a serendipity element, exponents of 1 don't count.
CellKind hex20() {
  const auto counted = [](int exponent) { return exponent > 1 ? exponent : 0; };
  CellKind kind = named("hex20", 17, 25, "C3D20");
  kind.gmsh_node = {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
  kind.monomials = chosen([&](int i, int j, int k) { return k >= 0 && counted(i) + counted(j) + counted(k) <= 2; });
  kind = brick(kind);
  kind.upright_at = hex27().places;
  return kind;
}

}  // namespace

int CellKind::middle_of(int corner, int other) const {
  const auto joins = [&](const std::array<int, 2>& edge) {
    return (edge[0] == corner && edge[1] == other) || (edge[0] == other && edge[1] == corner);
  };
  return corners + static_cast<int>(std::ranges::find_if(edges, joins) - edges.begin());
}

Eigen::VectorXd CellKind::shape(const Eigen::Vector3d& at) const {
  return coefficients * values(monomials, {at}).transpose();
}

Eigen::MatrixX3d CellKind::gradient(const Eigen::Vector3d& at) const {
  Eigen::MatrixX3d slopes(monomials.size(), 3);
  for (std::size_t m = 0; m < monomials.size(); ++m)
    for (int d = 0; d < 3; ++d) {
      Exponents lower = monomials[m];
      const int factor = lower[d]--;
      slopes(static_cast<Eigen::Index>(m), d) = factor == 0 ? 0 : factor * monomial(lower, at);
    }
  return coefficients * slopes;
}

const std::vector<CellKind>& all_cell_kinds() {
  static const std::vector<CellKind> kinds = {tet10(), pyramid13(), wedge15(), hex20(), hex27()};
  return kinds;
}

bool is_cell_kind(int nodes) {
  return std::ranges::any_of(all_cell_kinds(), [&](const CellKind& kind) { return kind.nodes() == nodes; });
}

const CellKind& cell_kind(int nodes) {
  for (const CellKind& kind : all_cell_kinds())
    if (kind.nodes() == nodes) return kind;
  throw std::logic_error("no kind of cell has " + std::to_string(nodes) + " nodes");
}

std::string cell_node_counts() {
  return "10, 13, 15, 20 or 27";
}

// A face is the lower side of a wedge or a brick.
Eigen::MatrixX3d face_shape(int nodes, double s, double t) {
  static const std::vector<int> triangle = {0, 1, 2, 6, 7, 8}, quadrangle = {0, 1, 2, 3, 8, 9, 10, 11, 24};
  const CellKind& kind = cell_kind(nodes == 6 ? 15 : nodes == 8 ? 20 : 27);
  const Eigen::Vector3d at(s, t, -1);
  const Eigen::VectorXd value = kind.shape(at);
  const Eigen::MatrixX3d slope = kind.gradient(at);
  Eigen::MatrixX3d shape(nodes, 3);
  for (int k = 0; k < nodes; ++k) {
    const int node = (nodes == 6 ? triangle : quadrangle)[static_cast<std::size_t>(k)];
    shape.row(k) << value[node], slope(node, 0), slope(node, 1);
  }
  return shape;
}

}  // namespace tiprub
