// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/added_functions.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <unsupported/Eigen/AutoDiff>

#include "mesh/cells/cell_kind.h"
#include "mesh/cells/gauss_points.h"
#include "reduce/sector/cut_faces.h"

namespace tiprub::reduce {

namespace {

/// The numbers of their corners.
struct Corners {
  enum { tetrahedron = 4, pyramid = 5, wedge = 6, brick = 8 };
};
constexpr int complete_brick_nodes = 27;

/// A number with its slopes in the reference cell.
using Varying = Eigen::AutoDiffScalar<Eigen::Vector3d>;

/// The linear functions of the corners, each of which is 1 at one corner and 0 at the others.
std::vector<Varying> corner_functions(const CellKind& kind, const Eigen::Vector3d& at) {
  const Varying x(at[0], 3, 0), y(at[1], 3, 1), z(at[2], 3, 2);
  const std::vector<Varying> triangle = {1 - x - y, x, y};
  if (kind.corners == Corners::tetrahedron) return {1 - x - y - z, x, y, z};
  std::vector<Varying> functions;
  for (int k = 0; k < kind.corners; ++k) {
    const Eigen::Vector3d& side = kind.places[k];
    if (kind.corners == Corners::wedge) functions.emplace_back(triangle[k % 3] * (1 + side[2] * z) / 2);
    if (kind.corners == Corners::brick)
      functions.emplace_back((1 + side[0] * x) / 2 * ((1 + side[1] * y) / 2) * ((1 + side[2] * z) / 2));
    if (kind.corners == Corners::pyramid)
      functions.emplace_back(k == Corners::pyramid - 1 ? Varying(1 + z)
                                                       : Varying((side[0] * x - z) * (side[1] * y - z) / (-4 * z)));
  }
  return functions;
}

/// A function of an edge (two corners), a face or a cell.
struct CellFunction {
  std::vector<int> corners;
  /// Those from which and to which it goes, if it is odd along an axis.
  std::array<std::vector<int>, 2> sides = {};
  std::vector<int> middles = {};  ///< nodes in the middles of its edges: one of an edge, three or four of a face
  std::vector<int> key = {};      ///< of these, if it is odd, those of the edges along its axis

  bool is_edge() const { return corners.size() == 2; }
};

/// s of AddedFunctions: the sum of the linear functions that are not zero on the edge or face where quadrangles go on
/// from all of it.
Varying across(const CellKind& kind, const CellFunction& function, const std::vector<Varying>& linear) {
  const auto sum = [&](const std::vector<int>& corners) {
    Varying total(0.0, Eigen::Vector3d::Zero());
    for (const int corner : corners) total += linear[corner];
    return total;
  };
  const auto level = [&](int corner) { return kind.places[corner][2]; };
  const bool flat = level(function.corners.front()) == level(function.corners.back());
  if (kind.corners == Corners::brick) return sum(function.corners);
  if (kind.corners == Corners::wedge && function.corners.size() < 4)
    return !flat ? sum(function.corners) : level(function.corners[0]) < 0 ? sum({0, 1, 2}) : sum({3, 4, 5});
  if (kind.corners == Corners::pyramid && function.is_edge() && flat)
    return sum(function.corners) / sum({0, 1, 2, 3});
  return sum({}) + 1;
}

Varying value_of(const CellKind& kind, const CellFunction& function, const std::vector<Varying>& linear) {
  const auto N = [&](std::size_t k) -> const Varying& { return linear[function.corners[k]]; };
  const Varying s = across(kind, function, linear);
  const auto even = [&]() -> Varying {
    if (function.is_edge()) return 4 * N(0) * N(1) / s;
    if (function.corners.size() == 3) return 27 * N(0) * N(1) * N(2) / (s * s);
    if (function.corners.size() == 4) return 16 * N(0) * N(2) / s;
    return 64 * N(0) * N(6);
  };
  if (function.sides[0].empty()) return even();
  Varying along(0.0, Eigen::Vector3d::Zero());
  for (const int corner : function.sides[0]) along -= linear[corner];
  for (const int corner : function.sides[1]) along += linear[corner];
  return even() * along / s;
}

void list_middles(const CellKind& kind, CellFunction& function) {
  const auto has = [](const std::vector<int>& corners, int corner) {
    return std::ranges::find(corners, corner) != corners.end();
  };
  for (std::size_t e = 0; e < kind.edges.size(); ++e) {
    const auto [a, b] = kind.edges[e];
    if (!has(function.corners, a) || !has(function.corners, b)) continue;
    function.middles.push_back(kind.corners + static_cast<int>(e));
    if (has(function.sides[0], a) == has(function.sides[0], b) && !function.sides[0].empty()) continue;
    function.key.push_back(function.middles.back());
  }
}

std::vector<CellFunction> functions_of(const CellKind& kind) {
  std::vector<CellFunction> functions;
  for (const auto& [a, b] : kind.edges) functions.push_back({{a, b}, {{{a}, {b}}}});
  const bool complete = kind.nodes() == complete_brick_nodes;
  for (const std::vector<int>& f : kind.faces) {
    if (!complete) functions.push_back({f});
    if (complete) functions.push_back({f, {{{f[0], f[3]}, {f[1], f[2]}}}});
    if (complete) functions.push_back({f, {{{f[0], f[1]}, {f[3], f[2]}}}});
  }
  const std::vector<int> all = {0, 1, 2, 3, 4, 5, 6, 7};
  if (kind.corners == Corners::brick && !complete) functions.push_back({all});
  for (int axis = 0; axis < 3 && complete; ++axis) {
    functions.push_back({all});
    for (const int corner : all) functions.back().sides[kind.places[corner][axis] < 0 ? 0 : 1].push_back(corner);
  }
  for (CellFunction& function : functions) list_middles(kind, function);
  return functions;
}

/// Four points along each direction. In a cell with triangles they are those of a brick of which sides are drawn
/// together, exact to the fifth degree.
std::vector<ReferencePoint> precise_points(const CellKind& kind) {
  const auto from_zero = [](double x) { return (1 + x) / 2; };
  std::vector<ReferencePoint> points;
  for (const auto& [c, wc] : gauss_points(4))
    for (const auto& [b, wb] : gauss_points(4))
      for (const auto& [a, wa] : gauss_points(4)) {
        const double weight = wa * wb * wc, u = from_zero(a), v = from_zero(b), w = from_zero(c);
        if (kind.corners == Corners::brick) points.push_back({{a, b, c}, weight});
        if (kind.corners == Corners::wedge) points.push_back({{u, (1 - u) * v, c}, weight / 4 * (1 - u)});
        if (kind.corners == Corners::pyramid) points.push_back({{w * a, w * b, -w}, weight / 2 * w * w});
        if (kind.corners == Corners::tetrahedron)
          points.push_back({{u, (1 - u) * v, (1 - u) * (1 - v) * w}, weight / 8 * (1 - u) * (1 - u) * (1 - v)});
      }
  return points;
}

/// Some functions and those of the nodes at integration points of the reference cell.
struct FunctionTable {
  FunctionTable(const CellKind& kind, const std::vector<CellFunction>& functions,
                const std::vector<ReferencePoint>& points);
  int nodes;
  Eigen::VectorXd weight;
  Eigen::MatrixXd value;                 ///< points x (functions, then nodes)
  std::array<Eigen::MatrixXd, 3> slope;  ///< likewise
};

FunctionTable::FunctionTable(const CellKind& kind, const std::vector<CellFunction>& functions,
                             const std::vector<ReferencePoint>& points)
    : nodes(kind.nodes()), weight(points.size()), value(points.size(), functions.size() + kind.nodes()) {
  slope.fill(value);
  for (Eigen::Index q = 0; q < weight.size(); ++q) {
    const ReferencePoint& point = points[static_cast<std::size_t>(q)];
    weight[q] = point.weight;
    value.row(q).tail(nodes) = kind.shape(point.at).transpose();
    const Eigen::MatrixX3d gradient = kind.gradient(point.at);
    for (int d = 0; d < 3; ++d) slope[d].row(q).tail(nodes) = gradient.col(d).transpose();
    const std::vector<Varying> linear = corner_functions(kind, point.at);
    for (std::size_t f = 0; f < functions.size(); ++f) {
      const Varying found = value_of(kind, functions[f], linear);
      value(q, static_cast<Eigen::Index>(f)) = found.value();
      for (int d = 0; d < 3; ++d) slope[d](q, static_cast<Eigen::Index>(f)) = found.derivatives()[d];
    }
  }
}

/// A kind of cell with its functions.
struct Element {
  explicit Element(const CellKind& kind)
      : functions(functions_of(kind)), table(kind, functions, precise_points(kind)) {}
  std::vector<CellFunction> functions;
  FunctionTable table;  ///< exact for the stiffness of cubic functions in a straight cell
};

const Element& element_of(Eigen::Index nodes) {
  static const std::map<Eigen::Index, Element> known = [] {
    std::map<Eigen::Index, Element> elements;
    for (const CellKind& kind : all_cell_kinds()) elements.try_emplace(kind.nodes(), kind);
    return elements;
  }();
  return known.at(nodes);
}

/// The integrals of the products of values and of slopes (d/dx_i of the row's, d/dx_j of the column's function) of
/// all functions of a table.
struct Products {
  Products(const FunctionTable& table, const Eigen::Matrix3Xd& places);
  Eigen::Matrix3d stiffness(const Material& material, Eigen::Index row, Eigen::Index column) const;

  Eigen::MatrixXd values;                                ///< [m^3]
  std::array<std::array<Eigen::MatrixXd, 3>, 3> slopes;  ///< [m]
};

Products::Products(const FunctionTable& table, const Eigen::Matrix3Xd& places) {
  std::array<Eigen::MatrixXd, 3> slope = table.slope;  // d/dx, from d/dxi
  Eigen::VectorXd volume(table.weight.size());
  for (Eigen::Index q = 0; q < volume.size(); ++q) {
    Eigen::Matrix3d jacobian;  // dx/dxi
    for (int d = 0; d < 3; ++d) jacobian.col(d) = places * table.slope[d].row(q).tail(table.nodes).transpose();
    const Eigen::Matrix3d inverse = jacobian.inverse();
    volume[q] = table.weight[q] * jacobian.determinant();
    for (int d = 0; d < 3; ++d)
      slope[d].row(q) = inverse(0, d) * table.slope[0].row(q) + inverse(1, d) * table.slope[1].row(q) +
                        inverse(2, d) * table.slope[2].row(q);
  }
  values = table.value.transpose() * volume.asDiagonal() * table.value;
  for (int i = 0; i < 3; ++i) {
    const Eigen::MatrixXd weighted = slope[i].transpose() * volume.asDiagonal();
    for (int j = 0; j < 3; ++j) slopes[i][j] = weighted * slope[j];
  }
}

/// int B' C B of an isotropic material.
Eigen::Matrix3d Products::stiffness(const Material& material, Eigen::Index row, Eigen::Index column) const {
  const double shear = material.young / (2 * (1 + material.poisson));
  const double lame = 2 * shear * material.poisson / (1 - 2 * material.poisson);
  Eigen::Matrix3d K;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) K(i, j) = lame * slopes[i][j](row, column) + shear * slopes[j][i](row, column);
  K.diagonal().array() += shear * (slopes[0][0](row, column) + slopes[1][1](row, column) + slopes[2][2](row, column));
  return K;
}

/// Blocks of 3 x 3 between the functions of two lists, in the frames of each.
template <class Block>
Eigen::MatrixXd assemble(const Block& block, const std::vector<Eigen::Index>& rows,
                         const std::vector<Eigen::Matrix3d>& row_frames, const std::vector<Eigen::Index>& columns,
                         const std::vector<Eigen::Matrix3d>& column_frames) {
  Eigen::MatrixXd matrix(3 * rows.size(), 3 * columns.size());
  for (std::size_t b = 0; b < columns.size(); ++b)
    for (std::size_t a = 0; a < rows.size(); ++a)
      matrix.block<3, 3>(3 * a, 3 * b) = (row_frames[a].transpose() * block(rows[a], columns[b]) * column_frames[b]);
  return matrix;
}

}  // namespace

std::vector<AddedFunctions::OfFace> AddedFunctions::of_face(int nodes) {
  constexpr int triangle = 6, complete = 9;
  if (nodes == triangle) return {{{{{0}, {1}}}, {0}}, {{{{1}, {2}}}, {1}}, {{{{2}, {0}}}, {2}}, {{}, {0, 1, 2}}};
  std::vector<OfFace> functions = {
      {{{{0}, {1}}}, {0}}, {{{{1}, {2}}}, {1}}, {{{{2}, {3}}}, {2}}, {{{{3}, {0}}}, {3}}};
  if (nodes != complete) functions.push_back({{}, {0, 1, 2, 3}});
  if (nodes == complete) functions.push_back({{{{0, 3}, {1, 2}}}, {0, 2}});
  if (nodes == complete) functions.push_back({{{{0, 1}, {3, 2}}}, {1, 3}});
  return functions;
}

std::vector<double> AddedFunctions::on_face(int nodes, double s, double t) {
  constexpr int triangle = 6;
  const CellKind& kind = cell_kind(nodes == triangle ? 15 : 20);  // the face is its lower side
  const std::vector<Varying> linear = corner_functions(kind, {s, t, -1});
  const std::vector<int> all = nodes == triangle ? std::vector{0, 1, 2} : std::vector{0, 1, 2, 3};
  std::vector<double> values;
  for (const OfFace& function : of_face(nodes)) {
    const auto& [from, to] = function.sides;
    const bool is_edge = from.size() == 1;
    values.push_back(value_of(kind, {is_edge ? std::vector{from[0], to[0]} : all, function.sides}, linear).value());
  }
  return values;
}

bool AddedFunctions::serve(const SectorMesh& mesh) {
  if (mesh.cubic != nullptr || mesh.cell_count() == 0) return false;
  int complete = 0;
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    complete += nodes_of(mesh.cells, cell).size() == complete_brick_nodes;
  if (complete > 0 && complete < mesh.cell_count()) return false;
  return cut_faces_are_equal(mesh);
}

double AddedFunctions::memory(const SectorMesh& mesh) {
  double bytes = 0;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const Eigen::Index nodes = nodes_of(mesh.cells, cell).size();
    const auto n = static_cast<double>(nodes), w = static_cast<double>(element_of(nodes).functions.size());
    bytes += 9 * (sizeof(double) * (w * n + n * n) + sizeof(float) * (w * w + (w + n) * n));
  }
  return bytes;
}

AddedFunctions::AddedFunctions(const SectorMesh& mesh)
    : mesh_(mesh), lower_(mesh.node_count(), -1), cells_(mesh.cell_count()) {
  for (std::size_t k = 0; k < mesh.cyclic_low.size(); ++k) lower_[mesh.cyclic_high[k]] = mesh.cyclic_low[k];
  std::vector<std::vector<int>> middles;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto nodes = nodes_of(mesh.cells, cell);
    const auto listed = [&](const std::vector<int>& of_cell) {
      std::vector<int> found;
      for (const int k : of_cell) found.push_back(nodes[k]);
      std::ranges::sort(found);
      return found;
    };
    // Of two partners on the cuts, both have the direction that the lower one has.
    const auto rank = [&](const std::vector<int>& corners) {
      std::pair<int, int> least(std::numeric_limits<int>::max(), 0);
      for (const int corner : corners)
        least = std::min(least,
                         std::pair(lower_[nodes[corner]] < 0 ? nodes[corner] : lower_[nodes[corner]], nodes[corner]));
      return least;
    };
    for (const CellFunction& function : element_of(nodes.size()).functions) {
      const auto [known, is_new] = numbers_.try_emplace(listed(function.key), static_cast<int>(numbers_.size()));
      if (is_new) middles.push_back(listed(function.middles));
      const bool reversed = rank(function.sides[1]) < rank(function.sides[0]);
      cells_[cell].push_back({known->second, reversed ? -1.0 : 1.0});
    }
  }
  number(middles);
}

void AddedFunctions::number(const std::vector<std::vector<int>>& middles) {
  std::vector<bool> clamped(mesh_.node_count()), low(mesh_.node_count());
  for (const int node : mesh_.clamped) clamped[node] = true;
  for (const int node : mesh_.cyclic_low) low[node] = true;
  const auto all = [&](int f, const auto& test) { return std::ranges::all_of(middles[f], test); };
  functions_.resize(numbers_.size());
  std::vector<int> interior, face;
  std::vector<std::pair<int, std::vector<int>>> high;  // with the key of the partner
  for (const auto& [key, f] : numbers_) {
    const Eigen::Matrix3Xd places = mesh_.nodes(Eigen::all, middles[f]);
    functions_[f].frame = cylindrical_frame(places.rowwise().mean());
    if (all(f, [&](int node) { return clamped[node]; })) continue;
    if (all(f, [&](int node) { return lower_[node] >= 0; })) {
      std::vector<int> partner;
      for (const int node : key) partner.push_back(lower_[node]);
      std::ranges::sort(partner);
      high.emplace_back(f, partner);
    } else {
      (all(f, [&](int node) { return low[node]; }) ? face : interior).push_back(f);
    }
  }
  dofs_.interior = static_cast<int>(3 * interior.size());
  dofs_.face = static_cast<int>(3 * face.size());
  dofs_.contact_loads.resize(dofs_.sector(), 0);
  int next = 0;
  for (const std::vector<int>* group : {&interior, &face})
    for (const int f : *group) functions_[f].first = 3 * next++;
  for (const auto& [f, partner] : high) functions_[f].first = functions_[numbers_.at(partner)].first + dofs_.face;
}

Eigen::MatrixXd AddedFunctions::contact_loads(const std::map<std::vector<int>, Eigen::VectorXd>& weights,
                                              int contacts) const {
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(dofs_.sector(), 3 * contacts);
  for (const auto& [middles, of_contacts] : weights) {
    const auto known = numbers_.find(middles);
    if (known == numbers_.end()) continue;  // a face of the group that is no cell's
    for (int k = 0; k < contacts; ++k)
      for (int d = 0; d < 3; ++d) loads(functions_[known->second].first + d, 3 * k + d) = of_contacts[k];
  }
  return loads;
}

AddedCell AddedFunctions::integrate(int cell, const SectorDofs& node_dofs, const Material& material) const {
  const auto listed = nodes_of(mesh_.cells, cell);
  const Products products(element_of(listed.size()).table, mesh_.nodes(Eigen::all, listed));
  AddedCell result;
  std::vector<Eigen::Index> moving, nodes, all;  // in the table
  std::vector<Eigen::Matrix3d> frames, node_frames, all_frames;
  for (const InCell& at : cells_[cell]) {
    const Function& function = functions_[at.function];
    if (function.first < 0) continue;
    moving.push_back(&at - cells_[cell].data());
    frames.push_back(at.sign * function.frame);
    result.functions.push_back(function.first);
  }
  for (const int node : listed) {
    nodes.push_back(static_cast<Eigen::Index>(cells_[cell].size() + nodes.size()));
    node_frames.push_back(cylindrical_frame(mesh_.nodes.col(node)));
    result.nodes.push_back(node_dofs.first[node]);
  }
  std::copy(nodes.begin(), nodes.end(), std::back_inserter(all = moving));
  std::copy(node_frames.begin(), node_frames.end(), std::back_inserter(all_frames = frames));
  const auto stiffness = [&](Eigen::Index a, Eigen::Index b) { return products.stiffness(material, a, b); };
  const auto mass = [&](Eigen::Index a, Eigen::Index b) {
    return Eigen::Matrix3d(material.density * products.values(a, b) * Eigen::Matrix3d::Identity());
  };
  result.stiffness = assemble(stiffness, moving, frames, moving, frames).cast<float>();
  result.coupling = assemble(stiffness, moving, frames, nodes, node_frames);
  result.of_nodes = assemble(stiffness, nodes, node_frames, nodes, node_frames);
  result.mass = assemble(mass, all, all_frames, nodes, node_frames).cast<float>();
  return result;
}

}  // namespace tiprub::reduce
