// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cells/free_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "mesh/cells/cell_kind.h"

namespace tiprub {

namespace {

constexpr double smooth_cosine = 0.94;  // of 20 degrees

Eigen::Vector3d normal_of(const Eigen::Matrix3Xd& nodes, const FreeFace& face) {
  const auto at = [&](std::size_t k) -> Eigen::Vector3d { return nodes.col(face.nodes[k]); };
  const std::size_t last = face.corners() - 1;
  Eigen::Vector3d normal = (at(1) - at(0)).cross(at(last) - at(0));
  if (last > 2) normal += (at(last) - at(last - 1)).cross(at(1) - at(last - 1));
  return normal.normalized();
}

}  // namespace

std::vector<std::vector<int>> listed_cells(const Eigen::MatrixXi& columns) {
  std::vector<std::vector<int>> cells;
  for (Eigen::Index cell = 0; cell < columns.cols(); ++cell) {
    const auto nodes = nodes_of(columns, cell);
    cells.emplace_back(nodes.begin(), nodes.end());
  }
  return cells;
}

std::vector<FreeFace> free_faces(const Eigen::Matrix3Xd& nodes, const std::vector<std::vector<int>>& cells) {
  std::map<std::vector<int>, std::pair<FreeFace, int>> faces;  // by their corners
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::vector<int>& cell = cells[c];
    const CellKind& kind = cell_kind(static_cast<int>(cell.size()));
    for (const std::vector<int>& around : kind.faces) {
      FreeFace face;
      face.cell = static_cast<int>(c);
      for (const int corner : around) face.nodes.push_back(cell[corner]);
      std::vector<int> key = face.nodes;
      std::ranges::sort(key);
      for (std::size_t k = 0; k < around.size(); ++k)
        face.nodes.push_back(cell[kind.middle_of(around[k], around[(k + 1) % around.size()])]);
      ++faces.try_emplace(key, face, 0).first->second.second;
    }
  }
  std::vector<FreeFace> free;
  for (auto& [key, found] : faces) {
    if (found.second > 1) continue;
    found.first.normal = normal_of(nodes, found.first);
    free.push_back(std::move(found.first));
  }
  return free;
}

std::array<int, 2> FreeFace::edge(std::size_t k) const {
  const auto [low, high] = std::minmax(nodes[k], nodes[(k + 1) % corners()]);
  return {low, high};
}

std::map<std::array<int, 2>, std::vector<int>> faces_at_edges(const std::vector<FreeFace>& faces,
                                                              const std::vector<int>& numbers) {
  std::map<std::array<int, 2>, std::vector<int>> found;
  for (const int number : numbers)
    for (std::size_t k = 0; k < faces[number].corners(); ++k) found[faces[number].edge(k)].push_back(number);
  return found;
}

std::vector<int> surface_patch(const std::vector<FreeFace>& faces, const std::vector<int>& from) {
  std::vector<int> all(faces.size());
  std::iota(all.begin(), all.end(), 0);
  const auto neighbours = faces_at_edges(faces, all);
  std::set<int> patch(from.begin(), from.end());
  std::vector<int> front(from);
  while (!front.empty()) {
    const FreeFace& face = faces[front.back()];
    front.pop_back();
    for (std::size_t k = 0; k < face.corners(); ++k)
      for (const int next : neighbours.at(face.edge(k)))
        if (faces[next].normal.dot(face.normal) > smooth_cosine && patch.insert(next).second) front.push_back(next);
  }
  return {patch.begin(), patch.end()};
}

std::array<int, 2> equal_cells(const std::vector<std::vector<int>>& cells) {
  std::map<std::vector<int>, int> seen;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    std::vector<int> nodes = cells[cell];
    std::ranges::sort(nodes);
    const auto [at, is_new] = seen.emplace(std::move(nodes), static_cast<int>(cell));
    if (!is_new) return {at->second, static_cast<int>(cell)};
  }
  return {-1, -1};
}

namespace {

std::string quoted(const std::string& part) {
  return "part \"" + part + "\"";
}

std::string wrong_lists(Eigen::Index cell_count, const NamedLists& parts) {
  std::vector<const std::string*> owner(static_cast<std::size_t>(cell_count));
  for (const auto& [part, cells] : parts) {
    if (cells.empty()) return quoted(part) + " has no cell of the sector";
    std::size_t taken = 0;
    const std::string* other = nullptr;
    for (const int cell : cells) {
      const std::string*& first = owner[static_cast<std::size_t>(cell)];
      if (first == &part) return quoted(part) + " lists cell " + std::to_string(cell) + " (from 0) twice";
      if (first != nullptr) ++taken, other = first;
      first = &part;
    }
    if (taken > 0)
      return std::to_string(taken) + " of the " + std::to_string(cells.size()) + " cells of " + quoted(part) +
             " are also in " + quoted(*other) + "; each cell belongs to one part";
  }
  return "";
}

}  // namespace

std::string wrong_parts(const Eigen::MatrixXi& cells, const NamedLists& parts, const NamedLists& tips) {
  if (const std::string wrong = wrong_lists(cells.cols(), parts); !wrong.empty()) return wrong;
  for (const auto& [part, tip] : tips) {
    if (!parts.contains(part)) continue;
    std::set<int> nodes;
    for (const int cell : parts.at(part))
      for (const int node : nodes_of(cells, cell)) nodes.insert(node);
    const auto outside = std::ranges::count_if(tip, [&](int node) { return !nodes.contains(node); });
    if (outside > 0)
      return quoted(part) + " does not hold " + std::to_string(outside) + " of the " + std::to_string(tip.size()) +
             " nodes of its tip line: are two parts exchanged?";
  }
  return "";
}

int listed_twice(std::vector<int> list) {
  std::ranges::sort(list);
  const auto twice = std::ranges::adjacent_find(list);
  return twice == list.end() ? -1 : *twice;
}

}  // namespace tiprub
