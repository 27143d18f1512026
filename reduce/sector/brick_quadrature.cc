// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/brick_quadrature.h"

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

using Cell = dealii::Triangulation<3>::cell_iterator;
using Info = dealii::GeometryInfo<3>;

constexpr int corners = 8, edges = 12, faces = 6, serendipity_nodes = 20, lagrange_nodes = 27;

// gmsh's corners in deal.II's order, the corner pairs of gmsh's mid-side nodes 8..19, and the corners of its
// face centres 20..25.
constexpr std::array<int, corners> gmsh_corner = {0, 1, 3, 2, 4, 5, 7, 6};
constexpr std::array<std::array<int, 2>, edges> gmsh_edge = {
    {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}}};
constexpr std::array<std::array<int, 4>, faces> gmsh_face = {
    {{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 3, 4, 7}, {1, 2, 5, 6}, {2, 3, 6, 7}, {4, 5, 6, 7}}};

template <std::size_t size>
std::array<int, size> sorted(std::array<int, size> key) {
  std::sort(key.begin(), key.end());
  return key;
}

/// Two cells that share an edge or a face must name the same node in its middle.
template <class Key>
void note(std::map<Key, int>& middle, const Key& corners_of, int node, const SectorMesh& mesh) {
  if (middle.try_emplace(corners_of, node).first->second != node)
    throw InputError(mesh.file + ": the cells don't make a mesh: neighbours disagree about the mid-side node at " +
                     mesh.place_of(node) + "; re-mesh, or merge double nodes");
}

/// Weights of the face centres (rows 0..5) and the cell centre (row 6) over 8 corners and 12 mid-sides, deal.II's
/// order.
Eigen::MatrixXd serendipity_weights() {
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(faces + 1, serendipity_nodes);
  for (int face = 0; face < faces; ++face) {
    for (int v = 0; v < 4; ++v) weights(face, Info::face_to_cell_vertices(face, v)) = -0.25;
    for (int l = 0; l < 4; ++l) weights(face, corners + Info::face_to_cell_lines(face, l)) = 0.5;
  }
  weights.row(faces).head(corners).setConstant(-0.25);
  weights.row(faces).tail(edges).setConstant(0.25);
  return weights;
}

/// deal.II's view of a sector.
struct DealIISector {
  explicit DealIISector(const SectorMesh& sector);
  [[noreturn]] void refuse(int cell, const dealii::Point<3>& at) const;
  BrickPoints points_of(int cell);
  void require_upright(int cell);

  void number_midside_nodes();
  void build_triangulation();
  std::vector<int> nodes_of(const Cell& cell) const;
  std::vector<dealii::Point<3>> support_points(const Cell& cell) const;

  const SectorMesh& mesh;
  dealii::Triangulation<3> triangulation;
  dealii::MappingQCache<3> mapping{2};
  dealii::FE_Q<3> element{2};
  dealii::QGauss<3> quadrature{3};
  std::unique_ptr<dealii::FEValues<3>> values, values_at_nodes;
  std::vector<Cell> cells;
  int nodes_per_cell;
  Eigen::MatrixXd combine;       ///< nodes of the brick x 27 shape functions of deal.II
  std::vector<int> corner_node;  ///< mesh node of each vertex of the triangulation
  std::map<std::array<int, 2>, int> edge_node;
  std::map<std::array<int, 4>, int> face_node;
  std::vector<int> centre_node;
};

DealIISector::DealIISector(const SectorMesh& sector) : mesh(sector), nodes_per_cell(mesh.nodes_per_cell()) {
  dealii::MultithreadInfo::set_thread_limit(1);  // its pool of threads would come beside ours
  number_midside_nodes();
  build_triangulation();
  mapping.initialize(triangulation, [&](const Cell& cell) { return support_points(cell); });
  values = std::make_unique<dealii::FEValues<3>>(mapping, element, quadrature,
                                                 dealii::update_values | dealii::update_gradients |
                                                     dealii::update_JxW_values | dealii::update_quadrature_points);
  values_at_nodes = std::make_unique<dealii::FEValues<3>>(
      mapping, element, dealii::Quadrature<3>(element.get_unit_support_points()),
      dealii::update_jacobians | dealii::update_quadrature_points);
  combine = Eigen::MatrixXd::Identity(nodes_per_cell, lagrange_nodes);
  if (nodes_per_cell == serendipity_nodes) combine.rightCols(faces + 1) = serendipity_weights().transpose();
}

void DealIISector::number_midside_nodes() {
  for (Eigen::Index cell = 0; cell < mesh.cells.cols(); ++cell) {
    const auto nodes = mesh.cells.col(cell);
    for (int e = 0; e < edges; ++e)
      note(edge_node, sorted<2>({nodes[gmsh_edge[e][0]], nodes[gmsh_edge[e][1]]}), nodes[corners + e], mesh);
    if (nodes_per_cell != lagrange_nodes) continue;
    for (int f = 0; f < faces; ++f) {
      const auto& at = gmsh_face[f];
      note(face_node, sorted<4>({nodes[at[0]], nodes[at[1]], nodes[at[2]], nodes[at[3]]}),
           nodes[serendipity_nodes + f], mesh);
    }
    centre_node.push_back(nodes[lagrange_nodes - 1]);
  }
}

void DealIISector::build_triangulation() {
  std::vector<int> vertex_of(mesh.node_count(), -1);
  std::vector<dealii::Point<3>> vertices;
  std::vector<dealii::CellData<3>> data(mesh.cell_count());
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    for (int v = 0; v < corners; ++v) {
      const int node = mesh.cells(gmsh_corner[v], cell);
      if (vertex_of[node] < 0) {
        vertex_of[node] = static_cast<int>(vertices.size());
        vertices.emplace_back(mesh.nodes(0, node), mesh.nodes(1, node), mesh.nodes(2, node));
        corner_node.push_back(node);
      }
      data[cell].vertices[v] = vertex_of[node];
    }
  dealii::GridTools::consistently_order_cells(data);
  triangulation.create_triangulation(vertices, data, dealii::SubCellData());
  for (const auto& cell : triangulation.cell_iterators()) cells.push_back(cell);
}

/// In the order of FE_Q(2): vertices, lines, faces, centre.
std::vector<int> DealIISector::nodes_of(const Cell& cell) const {
  std::vector<int> nodes;
  for (const unsigned int v : cell->vertex_indices()) nodes.push_back(corner_node[cell->vertex_index(v)]);
  for (const unsigned int l : cell->line_indices())
    nodes.push_back(edge_node.at(
        sorted<2>({corner_node[cell->line(l)->vertex_index(0)], corner_node[cell->line(l)->vertex_index(1)]})));
  if (nodes_per_cell != lagrange_nodes) return nodes;
  for (const unsigned int f : cell->face_indices()) {
    std::array<int, 4> key{};
    for (int v = 0; v < 4; ++v) key[v] = corner_node[cell->face(f)->vertex_index(v)];
    nodes.push_back(face_node.at(sorted<4>(key)));
  }
  nodes.push_back(centre_node[cell->index()]);
  return nodes;
}

std::vector<dealii::Point<3>> DealIISector::support_points(const Cell& cell) const {
  Eigen::Matrix3Xd positions(3, lagrange_nodes);
  const std::vector<int> nodes = nodes_of(cell);
  for (int i = 0; i < nodes_per_cell; ++i) positions.col(i) = mesh.nodes.col(nodes[i]);
  if (nodes_per_cell == serendipity_nodes)
    positions.rightCols(faces + 1) = positions.leftCols(serendipity_nodes) * serendipity_weights().transpose();
  std::vector<dealii::Point<3>> points_of_cell;
  for (const auto& at : positions.colwise()) points_of_cell.emplace_back(at.x(), at.y(), at.z());
  return points_of_cell;
}

void DealIISector::refuse(int cell, const dealii::Point<3>& at) const {
  throw InputError(mesh.file + ": " + mesh.name_of_cell(cell) + " is inverted or flat near " +
                   place_text({at[0], at[1], at[2]}) + "; re-mesh");
}

/// At its nodes (and where a 20-node brick has none, in the middles of its faces): a cell may be upright at all Gauss
/// points and turned inside out at a corner. The determinant counts over the lengths of the three edges there.
void DealIISector::require_upright(int cell) {
  constexpr double least = 1e-6;
  values_at_nodes->reinit(cells[cell]);
  for (unsigned int q = 0; q < values_at_nodes->n_quadrature_points; ++q) {
    Eigen::Matrix3d jacobian;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) jacobian(i, j) = values_at_nodes->jacobian(q)[i][j];
    if (!(jacobian.determinant() > least * jacobian.colwise().norm().prod()))
      refuse(cell, values_at_nodes->quadrature_point(q));
  }
}

BrickPoints DealIISector::points_of(int cell) {
  require_upright(cell);
  try {
    values->reinit(cells[cell]);
  } catch (const dealii::ExceptionBase&) {  // negative Jacobian
    refuse(cell, cells[cell]->center());
  }
  const int count = static_cast<int>(values->n_quadrature_points);
  BrickPoints points;
  points.nodes = nodes_of(cells[cell]);
  points.weight.resize(count);
  points.position.resize(3, count);
  points.gradient.resize(count);
  Eigen::MatrixXd shape(lagrange_nodes, count);
  Eigen::Matrix<double, lagrange_nodes, 3> gradient;
  for (int q = 0; q < count; ++q) {
    for (int i = 0; i < lagrange_nodes; ++i) {
      shape(i, q) = values->shape_value(i, q);
      for (int d = 0; d < 3; ++d) gradient(i, d) = values->shape_grad(i, q)[d];
    }
    points.gradient[q] = combine * gradient;
    points.weight[q] = values->JxW(q);
    for (int d = 0; d < 3; ++d) points.position(d, q) = values->quadrature_point(q)[d];
    if (!(points.weight[q] > 0)) refuse(cell, values->quadrature_point(q));
  }
  points.shape = combine * shape;
  return points;
}

}  // namespace

BrickQuadrature::BrickQuadrature(const SectorMesh& mesh) {
  try {
    DealIISector sector(mesh);
    cells_.reserve(mesh.cell_count());
    for (int cell = 0; cell < mesh.cell_count(); ++cell) cells_.push_back(sector.points_of(cell));
  } catch (const dealii::ExceptionBase& error) {
    throw InputError(mesh.file + ": the cells don't make a mesh: deal.II's " + error.get_exc_name());
  } catch (const std::out_of_range&) {
    throw InputError(mesh.file + ": the cells don't make a mesh: neighbours disagree about a mid-side node");
  }
}

}  // namespace tiprub
