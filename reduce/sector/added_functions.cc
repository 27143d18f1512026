// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/added_functions.h"

#include <algorithm>
#include <map>
#include <span>

#include "mesh/cells/cell_kind.h"
#include "mesh/cells/gauss_points.h"

namespace tiprub::reduce {

namespace {

constexpr int brick_nodes = 20;

/// The functions of one coordinate that make those of a cell, as products.
enum class Factor { down, up, quadratic, cubic };

/// Value and slope.
std::array<double, 2> evaluate(Factor factor, double x) {
  switch (factor) {
    case Factor::down:
      return {(1 - x) / 2, -0.5};
    case Factor::up:
      return {(1 + x) / 2, 0.5};
    case Factor::quadratic:
      return {1 - x * x, -2 * x};
    case Factor::cubic:
      break;
  }
  return {x * (1 - x * x), 1 - 3 * x * x};
}

/// A function of the reference cell.
struct CellFunction {
  std::array<Factor, 3> factors;
  std::vector<int> middles;          ///< nodes in the middles of its edges: one of an edge, four of a face
  std::array<int, 2> ends = {0, 0};  ///< of an edge, in the direction of the coordinate
};

CellFunction function_between(const CellKind& kind, const std::vector<int>& corners, Factor bubble) {
  CellFunction function;
  for (int d = 0; d < 3; ++d) {
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end(),
                                                 [&](int a, int b) { return kind.places[a][d] < kind.places[b][d]; });
    const bool along = kind.places[*low][d] < kind.places[*high][d];
    function.factors[d] = along ? bubble : kind.places[*low][d] < 0 ? Factor::down : Factor::up;
    if (along) function.ends = {*low, *high};
  }
  const auto has = [&](int corner) { return std::find(corners.begin(), corners.end(), corner) != corners.end(); };
  for (std::size_t e = 0; e < kind.edges.size(); ++e)
    if (has(kind.edges[e][0]) && has(kind.edges[e][1]))
      function.middles.push_back(kind.corners + static_cast<int>(e));
  return function;
}

std::vector<CellFunction> functions_of_brick() {
  const CellKind& kind = cell_kind(brick_nodes);
  std::vector<CellFunction> functions;
  for (const auto& [a, b] : kind.edges) functions.push_back(function_between(kind, {a, b}, Factor::cubic));
  for (const std::vector<int>& face : kind.faces)
    functions.push_back(function_between(kind, face, Factor::quadratic));
  functions.push_back(function_between(kind, {0, 1, 2, 3, 4, 5, 6, 7}, Factor::quadratic));
  return functions;
}

/// Cubic functions and those of the nodes at integration points of the reference cell.
struct FunctionTable {
  FunctionTable(const std::vector<CellFunction>& functions, int points_a_direction);
  Eigen::VectorXd weight;
  Eigen::MatrixXd value;                 ///< points x (cubic functions, then nodes)
  std::array<Eigen::MatrixXd, 3> slope;  ///< likewise
};

FunctionTable::FunctionTable(const std::vector<CellFunction>& functions, int points_a_direction) {
  const CellKind& kind = cell_kind(brick_nodes);
  const std::span<const GaussPoint> line = gauss_points(points_a_direction);
  const auto n = static_cast<Eigen::Index>(line.size()), cubic = static_cast<Eigen::Index>(functions.size());
  weight.resize(n * n * n);
  value.resize(n * n * n, cubic + brick_nodes);
  slope.fill(value);
  for (Eigen::Index q = 0; q < weight.size(); ++q) {
    const GaussPoint &x = line[q % n], &y = line[q / n % n], &z = line[q / n / n];
    const Eigen::Vector3d at(x.x, y.x, z.x);
    weight[q] = x.weight * y.weight * z.weight;
    value.row(q).tail<brick_nodes>() = kind.shape(at).transpose();
    const Eigen::MatrixX3d gradient = kind.gradient(at);
    for (int d = 0; d < 3; ++d) slope[d].row(q).tail<brick_nodes>() = gradient.col(d).transpose();
    for (Eigen::Index f = 0; f < cubic; ++f) {
      std::array<std::array<double, 2>, 3> factor;
      for (int d = 0; d < 3; ++d) factor[d] = evaluate(functions[f].factors[d], at[d]);
      value(q, f) = factor[0][0] * factor[1][0] * factor[2][0];
      slope[0](q, f) = factor[0][1] * factor[1][0] * factor[2][0];
      slope[1](q, f) = factor[0][0] * factor[1][1] * factor[2][0];
      slope[2](q, f) = factor[0][0] * factor[1][0] * factor[2][1];
    }
  }
}

struct Brick {
  std::vector<CellFunction> functions = functions_of_brick();
  FunctionTable own{functions, 3};      ///< at the points that integrate the brick itself
  FunctionTable precise{functions, 4};  ///< exact for the squares of cubic functions
};

const Brick& brick() {
  static const Brick known;
  return known;
}

/// The integrals of the products of values and of slopes (d/dx_i of the row's, d/dx_j of the column's function) of
/// all functions, cubic ones and those of the nodes.
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
    for (int d = 0; d < 3; ++d) jacobian.col(d) = places * table.slope[d].row(q).tail<brick_nodes>().transpose();
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

}  // namespace

std::array<double, AddedFunctions::on_a_face> AddedFunctions::on_face(double s, double t) {
  const double along_s = evaluate(Factor::cubic, s)[0], along_t = evaluate(Factor::cubic, t)[0];
  return {along_s * (1 - t) / 2, along_t * (1 + s) / 2, -along_s * (1 + t) / 2, -along_t * (1 - s) / 2,
          (1 - s * s) * (1 - t * t)};
}

bool AddedFunctions::serve(const SectorMesh& mesh) {
  if (mesh.cubic != nullptr) return false;
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    if (nodes_of(mesh.cells, cell).size() != brick_nodes) return false;
  return mesh.cell_count() > 0;
}

AddedFunctions::AddedFunctions(const SectorMesh& mesh)
    : mesh_(mesh), lower_(mesh.node_count(), -1), cells_(mesh.cell_count()) {
  for (std::size_t k = 0; k < mesh.cyclic_low.size(); ++k) lower_[mesh.cyclic_high[k]] = mesh.cyclic_low[k];
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto nodes = nodes_of(mesh.cells, cell);
    // Of two partners on the cuts, both have the direction that the lower one has.
    const auto rank = [&](int corner) {
      const int node = nodes[corner];
      return std::pair(lower_[node] < 0 ? node : lower_[node], node);
    };
    for (const CellFunction& function : brick().functions) {
      std::vector<int> key;
      for (const int middle : function.middles) key.push_back(nodes[middle]);
      std::sort(key.begin(), key.end());
      const auto known = numbers_.try_emplace(key, static_cast<int>(numbers_.size())).first;
      const bool reversed = function.middles.size() == 1 && rank(function.ends[1]) < rank(function.ends[0]);
      cells_[cell].push_back({known->second, reversed ? -1.0 : 1.0});
    }
  }
  number();
}

void AddedFunctions::number() {
  std::vector<bool> clamped(mesh_.node_count()), low(mesh_.node_count());
  for (const int node : mesh_.clamped) clamped[node] = true;
  for (const int node : mesh_.cyclic_low) low[node] = true;
  const auto all = [](const std::vector<int>& nodes, const auto& test) {
    return std::all_of(nodes.begin(), nodes.end(), test);
  };
  functions_.resize(numbers_.size());
  std::vector<int> interior, face;
  std::vector<std::pair<int, std::vector<int>>> high;  // with the middles of the partner's edges
  for (const auto& [middles, f] : numbers_) {
    const Eigen::Matrix3Xd places = mesh_.nodes(Eigen::all, middles);
    functions_[f].frame = cylindrical_frame(places.rowwise().mean());
    if (all(middles, [&](int node) { return clamped[node]; })) continue;
    std::vector<int> partner;
    for (const int node : middles) partner.push_back(lower_[node]);
    std::sort(partner.begin(), partner.end());
    if (partner.front() >= 0)
      high.emplace_back(f, partner);
    else
      (all(middles, [&](int node) { return low[node]; }) ? face : interior).push_back(f);
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
  for (const auto& [middles, of_contacts] : weights)
    for (int k = 0; k < contacts; ++k)
      for (int d = 0; d < 3; ++d) loads(functions_[numbers_.at(middles)].first + d, 3 * k + d) = of_contacts[k];
  return loads;
}

AddedCell AddedFunctions::integrate(int cell, const SectorDofs& node_dofs, const Material& material) const {
  const auto listed = nodes_of(mesh_.cells, cell);
  const Eigen::Matrix3Xd places = mesh_.nodes(Eigen::all, listed);
  const Products own(brick().own, places), precise(brick().precise, places);
  AddedCell result;
  std::vector<Eigen::Index> moving, nodes;  // in the tables
  std::vector<Eigen::Matrix3d> frames, node_frames;
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
  const auto assemble = [](const auto& block, const auto& rows, const auto& row_frames, const auto& columns,
                           const auto& column_frames) {
    Eigen::MatrixXd matrix(3 * rows.size(), 3 * columns.size());
    for (std::size_t b = 0; b < columns.size(); ++b)
      for (std::size_t a = 0; a < rows.size(); ++a)
        matrix.block<3, 3>(3 * a, 3 * b) =
            (row_frames[a].transpose() * block(rows[a], columns[b]) * column_frames[b]);
    return matrix;
  };
  const auto stiffness = [&](const Products& of) {
    return [&](Eigen::Index a, Eigen::Index b) { return of.stiffness(material, a, b); };
  };
  const auto mass = [&](Eigen::Index a, Eigen::Index b) {
    return Eigen::Matrix3d(material.density * own.values(a, b) * Eigen::Matrix3d::Identity());
  };
  result.stiffness = assemble(stiffness(precise), moving, frames, moving, frames);
  result.coupling = assemble(stiffness(own), moving, frames, nodes, node_frames);
  result.of_nodes = assemble(stiffness(own), nodes, node_frames, nodes, node_frames);
  result.mass = assemble(mass, moving, frames, nodes, node_frames).cast<float>();
  return result;
}

}  // namespace tiprub::reduce
