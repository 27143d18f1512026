// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/cell_quadrature.h"

#include <algorithm>
#include <map>
#include <set>

#include "cases/program/errors.h"
#include "mesh/cells/cell_kind.h"

namespace tiprub {

namespace {

using Key = std::vector<int>;

/// A kind's shape functions at its integration points and where it must be upright.
struct ReferenceValues {
  explicit ReferenceValues(const CellKind& of) : kind(of), shape(of.nodes(), of.integration.size()) {
    for (const ReferencePoint& point : kind.integration) {
      shape.col(static_cast<Eigen::Index>(gradient.size())) = kind.shape(point.at);
      gradient.push_back(kind.gradient(point.at));
    }
    for (const Eigen::Vector3d& at : kind.upright_at) {
      upright_shape.push_back(kind.shape(at));
      upright_gradient.push_back(kind.gradient(at));
    }
  }

  const CellKind& kind;
  Eigen::MatrixXd shape;
  std::vector<Eigen::MatrixX3d> gradient, upright_gradient;
  std::vector<Eigen::VectorXd> upright_shape;
};

Key sorted(Key key) {
  std::sort(key.begin(), key.end());
  return key;
}

/// Checks that neighbours agree about the mid-side nodes and the faces that they share.
class Neighbours {
 public:
  explicit Neighbours(const SectorMesh& mesh) : mesh_(mesh) {}

  void add(const std::vector<int>& nodes, const CellKind& kind) {
    for (std::size_t e = 0; e < kind.edges.size(); ++e)
      note({nodes[kind.edges[e][0]], nodes[kind.edges[e][1]]}, nodes[kind.corners + e]);
    const std::size_t first_centre = kind.corners + kind.edges.size();
    for (std::size_t f = 0; f < kind.faces.size(); ++f) {
      Key corners;
      for (const int corner : kind.faces[f]) corners.push_back(nodes[corner]);
      if (nodes.size() > first_centre) note(corners, nodes[first_centre + f]);
      if (++faces_[sorted(corners)] > 2)
        refuse("three of them share the face at " + mesh_.place_of(corners.front()) + "; re-mesh");
    }
  }

  /// Refuses a quadrangle of only one cell that has the place of triangles of only one cell.
  void require_closed() const {
    std::set<Key> triangles;
    for (const auto& [corners, cells] : faces_)
      if (cells == 1 && corners.size() == 3) triangles.insert(corners);
    if (triangles.empty()) return;
    for (const auto& [corners, cells] : faces_)
      for (std::size_t left_out = 0; cells == 1 && corners.size() == 4 && left_out < 4; ++left_out) {
        Key three = corners;
        three.erase(three.begin() + static_cast<std::ptrdiff_t>(left_out));
        if (triangles.contains(three))
          refuse("a quadrangle meets triangles at " + mesh_.place_of(three.front()) +
                 "; put pyramids between bricks and tetrahedra");
      }
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(mesh_.file + ": the cells don't make a mesh: " + why);
  }

  void note(const Key& corners, int node) {
    if (middle_.try_emplace(sorted(corners), node).first->second != node)
      refuse("neighbours disagree about the mid-side node at " + mesh_.place_of(node) +
             "; re-mesh, or merge double nodes");
  }

  const SectorMesh& mesh_;
  std::map<Key, int> middle_;  // node, by the corners around it
  std::map<Key, int> faces_;   // how many cells have them
};

[[noreturn]] void refuse(const SectorMesh& mesh, int cell, const Eigen::Vector3d& at) {
  throw InputError(mesh.file + ": " + mesh.name_of_cell(cell) + " is inverted or flat near " + place_text(at) +
                   "; re-mesh");
}

/// At its nodes (and where a 20-node brick has none, in the middles of its faces): a cell may be upright at all Gauss
/// points and turned inside out at a corner. The determinant counts over the lengths of the three edges there.
void require_upright(const SectorMesh& mesh, int cell, const Eigen::Matrix3Xd& places,
                     const ReferenceValues& values) {
  constexpr double least = 1e-6;
  for (std::size_t q = 0; q < values.upright_gradient.size(); ++q) {
    const Eigen::Matrix3d jacobian = places * values.upright_gradient[q];
    if (!(jacobian.determinant() > least * jacobian.colwise().norm().prod()))
      refuse(mesh, cell, places * values.upright_shape[q]);
  }
}

CellPoints points_of(const SectorMesh& mesh, int cell, const std::vector<int>& nodes, const ReferenceValues& values) {
  const Eigen::Matrix3Xd places = mesh.nodes(Eigen::all, nodes);
  require_upright(mesh, cell, places, values);
  CellPoints points{nodes, values.shape, {}, Eigen::VectorXd(values.shape.cols()), places * values.shape};
  for (std::size_t q = 0; q < values.gradient.size(); ++q) {
    const auto point = static_cast<Eigen::Index>(q);
    const Eigen::Matrix3d jacobian = places * values.gradient[q];  // dx/dxi
    points.weight[point] = values.kind.integration[q].weight * jacobian.determinant();
    if (!(points.weight[point] > 0)) refuse(mesh, cell, points.position.col(point));
    points.gradient.emplace_back(values.gradient[q] * jacobian.inverse());
  }
  return points;
}

}  // namespace

CellQuadrature::CellQuadrature(const SectorMesh& mesh) {
  std::map<int, ReferenceValues> values;
  for (const CellKind& kind : all_cell_kinds()) values.try_emplace(kind.nodes(), kind);
  Neighbours neighbours(mesh);
  cells_.reserve(mesh.cell_count());
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto listed = nodes_of(mesh.cells, cell);
    const ReferenceValues& reference = values.at(static_cast<int>(listed.size()));
    const std::vector<int> nodes(listed.begin(), listed.end());
    neighbours.add(nodes, reference.kind);
    cells_.push_back(points_of(mesh, cell, nodes, reference));
  }
  neighbours.require_closed();
}

}  // namespace tiprub
