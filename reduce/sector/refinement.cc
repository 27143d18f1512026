// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/refinement.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/cells/cell_kind.h"
#include "reduce/sector/cell_checks.h"

namespace tiprub::reduce {

namespace {

using Places = std::vector<Eigen::Vector3d>;  // in the reference cell

/// The nodes that a point follows, with their weights in units of 2^-20. Neighbours give the same stencil to a point
/// that they share.
using Stencil = std::vector<std::pair<int, long>>;

/// The octahedron between the middles of a tetrahedron's edges is split into four about one of its diagonals.
std::vector<Places> inner_tetrahedra(const CellKind& kind) {
  const auto middle = [&](int a, int b) -> Eigen::Vector3d { return kind.places[kind.middle_of(a, b)]; };
  const Eigen::Vector3d top = middle(0, 2), bottom = middle(1, 3);
  const Places around = {middle(0, 1), middle(1, 2), middle(2, 3), middle(0, 3)};
  std::vector<Places> children;
  for (std::size_t k = 0; k < around.size(); ++k) {
    const Eigen::Vector3d &a = around[k], &b = around[(k + 1) % around.size()];
    const bool upright = (bottom - top).cross(a - top).dot(b - top) > 0;
    children.push_back(upright ? Places{top, bottom, a, b} : Places{top, bottom, b, a});
  }
  return children;
}

/// The two wedges between those at the corners are turned by half a turn about the axis.
std::vector<Places> inner_wedges(const CellKind& kind) {
  std::vector<Places> children;
  for (const double level : {-1.0, 1.0}) {
    children.emplace_back();
    for (int corner = 0; corner < kind.corners; ++corner) {
      const Eigen::Vector3d& at = kind.places[corner];
      children.back().emplace_back((1 - at[0]) / 2, (1 - at[1]) / 2, (at[2] + level) / 2);
    }
  }
  return children;
}

/// The corners of the children. One child, half as large as the cell, lies at each of its corners; others lie
/// between them.
std::vector<Places> children_of(const CellKind& kind) {
  std::vector<Places> children;
  if (kind.corners == 4) children = inner_tetrahedra(kind);
  if (kind.corners == 6) children = inner_wedges(kind);
  for (int at = 0; at < kind.corners; ++at) {
    children.emplace_back();
    for (int corner = 0; corner < kind.corners; ++corner)
      children.back().push_back((kind.places[corner] + kind.places[at]) / 2);
  }
  return children;
}

/// The places of all nodes of a child with these corners.
Places nodes_of_child(const CellKind& kind, const Places& corners) {
  Places places = corners;
  for (const auto& [a, b] : kind.edges) places.push_back((corners[a] + corners[b]) / 2);
  if (kind.nodes() == static_cast<int>(places.size())) return places;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const std::vector<int>& face : kind.faces) {
    places.emplace_back(0, 0, 0);
    for (const int corner : face) places.back() += corners[corner] / 4;
    centre += places.back() / 6;
  }
  places.push_back(centre);
  return places;
}

/// The places of all nodes of the four parts of a face of 6, 8 or 9 nodes (see face_shape()).
std::vector<Places> children_of_face(int nodes) {
  const bool triangle = nodes == 6;
  const Places whole =
      triangle ? Places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}} : Places{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  std::vector<Places> children;
  if (triangle) children.push_back({{0.5, 0.5, 0}, {0, 0.5, 0}, {0.5, 0, 0}});
  for (const Eigen::Vector3d& at : whole) {
    children.emplace_back();
    for (const Eigen::Vector3d& corner : whole) children.back().push_back((corner + at) / 2);
  }
  for (Places& child : children) {
    for (std::size_t k = 0; k < whole.size(); ++k) child.push_back((child[k] + child[(k + 1) % whole.size()]) / 2);
    if (nodes == 9) child.push_back((child[0] + child[2]) / 2);
  }
  return children;
}

class Refinement {
 public:
  explicit Refinement(const SectorMesh& mesh) : coarse_(mesh), fine_(mesh) {
    for (int node = 0; node < mesh.node_count(); ++node) places_.push_back(mesh.nodes.col(node));
  }

  SectorMesh run() {
    require_sound_cells(coarse_);
    split_cells();
    fine_.nodes.resize(3, static_cast<Eigen::Index>(places_.size()));
    for (std::size_t k = 0; k < places_.size(); ++k) fine_.nodes.col(static_cast<Eigen::Index>(k)) = places_[k];
    fine_.tip_faces = split_faces(coarse_.tip_faces);
    fine_.splitter_faces = split_faces(coarse_.splitter_faces);
    extend_groups();
    return std::move(fine_);
  }

 private:
  Stencil stencil(const Eigen::VectorXd& weights, const std::vector<int>& nodes) const {
    constexpr double unit = 1 << 20;
    Stencil found;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (const long weight = std::lround(unit * weights[static_cast<Eigen::Index>(k)]); weight != 0)
        found.emplace_back(nodes[k], weight);
    std::ranges::sort(found);
    return found;
  }

  int number(const Eigen::VectorXd& weights, const std::vector<int>& nodes) {
    const Stencil key = stencil(weights, nodes);
    if (key.size() == 1) return key.front().first;
    const auto [known, is_new] = numbers_.try_emplace(key, static_cast<int>(places_.size()));
    if (is_new) places_.push_back(coarse_.nodes(Eigen::all, nodes) * weights);
    return known->second;
  }

  void split_cells() {
    std::vector<std::vector<int>> cells;
    std::vector<std::vector<int>> children(coarse_.cell_count());
    fine_.cell_tags.clear();
    for (int cell = 0; cell < coarse_.cell_count(); ++cell) {
      const auto listed = nodes_of(coarse_.cells, cell);
      const std::vector<int> nodes(listed.begin(), listed.end());
      const CellKind& kind = cell_kind(static_cast<int>(nodes.size()));
      if (kind.corners == 5)
        refuse(coarse_, coarse_.name_of_cell(cell),
               " is a pyramid, which [reduce] refine can't split; leave refine at 0");
      for (const Places& corners : children_of(kind)) {
        children[cell].push_back(static_cast<int>(cells.size()));
        cells.emplace_back();
        for (const Eigen::Vector3d& at : nodes_of_child(kind, corners))
          cells.back().push_back(number(kind.shape(at), nodes));
        if (!coarse_.cell_tags.empty()) fine_.cell_tags.push_back(coarse_.cell_tags[cell]);
      }
    }
    fine_.cells = Eigen::MatrixXi::Constant(coarse_.cells.rows(), static_cast<Eigen::Index>(cells.size()), -1);
    for (std::size_t c = 0; c < cells.size(); ++c)
      std::copy(cells[c].begin(), cells[c].end(), fine_.cells.col(static_cast<Eigen::Index>(c)).begin());
    for (auto& [part, members] : fine_.parts) {
      std::vector<int> split;
      for (const int cell : members) split.insert(split.end(), children[cell].begin(), children[cell].end());
      members = split;
    }
  }

  /// Splits the faces of a tip as the cells beneath them are split.
  Eigen::MatrixXi split_faces(const Eigen::MatrixXi& faces) {
    std::vector<std::vector<int>> fine;
    for (Eigen::Index face = 0; face < faces.cols(); ++face) {
      const auto listed = nodes_of(faces, face);
      const std::vector<int> nodes(listed.begin(), listed.end());
      for (const Places& places : children_of_face(static_cast<int>(nodes.size()))) {
        fine.emplace_back();
        for (const Eigen::Vector3d& at : places)
          fine.back().push_back(number(face_shape(static_cast<int>(nodes.size()), at[0], at[1]).col(0), nodes));
      }
    }
    Eigen::MatrixXi table = Eigen::MatrixXi::Constant(faces.rows(), static_cast<Eigen::Index>(fine.size()), -1);
    for (std::size_t f = 0; f < fine.size(); ++f)
      std::copy(fine[f].begin(), fine[f].end(), table.col(static_cast<Eigen::Index>(f)).begin());
    return table;
  }

  /// A new node belongs to a group if all nodes that it follows do: it then lies on a face or an edge of the group.
  void extend_groups() {
    const std::set<int> clamped(coarse_.clamped.begin(), coarse_.clamped.end());
    std::map<int, int> partner;
    for (std::size_t k = 0; k < coarse_.cyclic_low.size(); ++k)
      partner[coarse_.cyclic_low[k]] = coarse_.cyclic_high[k];
    for (const auto& entry : numbers_) {
      const Stencil& key = entry.first;
      const int node = entry.second;
      const auto all = [&](const auto& group) {
        return std::ranges::all_of(key, [&](const auto& followed) { return group.contains(followed.first); });
      };
      if (all(clamped)) fine_.clamped.push_back(node);
      if (!all(partner)) continue;
      Stencil turned = key;
      for (auto& [followed, weight] : turned) followed = partner.at(followed);
      std::ranges::sort(turned);
      const auto high = numbers_.find(turned);
      if (high == numbers_.end())
        refuse(coarse_, "the cells divide cyclic_low and cyclic_high differently near ", place_text(places_[node]),
               ", so that [reduce] refine can't pair them; re-mesh");
      fine_.cyclic_low.push_back(node);
      fine_.cyclic_high.push_back(high->second);
    }
  }

  const SectorMesh& coarse_;
  SectorMesh fine_;
  Places places_;
  std::map<Stencil, int> numbers_;
};

}  // namespace

SectorMesh refined(const SectorMesh& mesh) {
  return Refinement(mesh).run();
}

}  // namespace tiprub::reduce
