// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/cell_checks.h"

#include <algorithm>
#include <map>
#include <set>

#include "mesh/cells/cell_kind.h"

namespace tiprub::reduce {

namespace {

using Key = std::vector<int>;

/// A kind's shape functions where its cells must be upright.
struct UprightValues {
  explicit UprightValues(const CellKind& kind) {
    for (const Eigen::Vector3d& at : kind.upright_at) {
      shape.push_back(kind.shape(at));
      gradient.push_back(kind.gradient(at));
    }
  }

  std::vector<Eigen::VectorXd> shape;
  std::vector<Eigen::MatrixX3d> gradient;
};

Key sorted(Key key) {
  std::ranges::sort(key);
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
    reduce::refuse(mesh_, "the cells don't make a mesh: ", why);
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

/// At its nodes (and where a 20-node brick has none, in the middles of its faces): a cell may be upright at all Gauss
/// points and turned inside out at a corner. The determinant counts over the lengths of the three edges there.
void require_upright(const SectorMesh& mesh, int cell, const UprightValues& values) {
  constexpr double least = 1e-6;
  const Eigen::Matrix3Xd places = mesh.nodes(Eigen::all, nodes_of(mesh.cells, cell));
  for (std::size_t q = 0; q < values.gradient.size(); ++q) {
    const Eigen::Matrix3d jacobian = places * values.gradient[q];
    if (!(jacobian.determinant() > least * jacobian.colwise().norm().prod()))
      refuse_inverted(mesh, cell, places * values.shape[q]);
  }
}

}  // namespace

void refuse_inverted(const SectorMesh& mesh, int cell, const Eigen::Vector3d& at) {
  refuse(mesh, mesh.name_of_cell(cell), " is inverted or flat near ", place_text(at), "; re-mesh");
}

void require_sound_cells(const SectorMesh& mesh) {
  std::map<int, UprightValues> values;
  for (const CellKind& kind : all_cell_kinds()) values.try_emplace(kind.nodes(), kind);
  Neighbours neighbours(mesh);
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto listed = nodes_of(mesh.cells, cell);
    const int count = static_cast<int>(listed.size());
    neighbours.add({listed.begin(), listed.end()}, cell_kind(count));
    require_upright(mesh, cell, values.at(count));
  }
  neighbours.require_closed();
}

}  // namespace tiprub::reduce
