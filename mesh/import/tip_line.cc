// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/tip_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

constexpr double least_step = 1e-4;  // of the line's length

Eigen::Vector2d meridional(const CellMesh& mesh, int node) {
  return {mesh.nodes.col(node).head<2>().norm(), mesh.nodes(2, node)};
}

int first_of(const CellMesh& mesh, const std::vector<int>& nodes, LeadingEdge leading) {
  const double sign = leading == LeadingEdge::low_z ? 1 : -1, same = 1e-9 * mesh.largest_radius();
  return *std::min_element(nodes.begin(), nodes.end(), [&](int a, int b) {
    const Eigen::Vector2d at = meridional(mesh, a), other = meridional(mesh, b);
    return std::abs(at[1] - other[1]) > same ? sign * at[1] < sign * other[1] : at[0] < other[0];
  });
}

/// Those of a way that come farther from its first node.
std::vector<int> advancing(const CellMesh& mesh, const std::vector<int>& way) {
  const auto distance = [&](int node) { return (meridional(mesh, node) - meridional(mesh, way.front())).norm(); };
  double length = 0;
  for (const int node : way) length = std::max(length, distance(node));
  std::vector<int> kept = {way.front()};
  for (const int node : way)
    if (distance(node) > distance(kept.back()) + least_step * length) kept.push_back(node);
  return kept;
}

/// The nodes round the faces, mid-sides too.
std::vector<int> loop_round(const CellMesh& mesh, const std::vector<int>& faces, const std::string& key) {
  std::map<std::array<int, 2>, int> directed;  // the middle, by the ends of an edge in the face's direction
  for (const int f : faces) {
    const FreeFace& face = mesh.faces[static_cast<std::size_t>(f)];
    const std::size_t corners = face.corners();
    for (std::size_t k = 0; k < corners; ++k)
      directed[{face.nodes[k], face.nodes[(k + 1) % corners]}] = face.nodes[corners + k];
  }
  std::map<int, std::array<int, 2>> next;  // middle and end, by the edge's begin
  std::size_t outer = 0;
  for (const auto& [ends, middle] : directed)
    if (!directed.contains({ends[1], ends[0]})) {
      next[ends[0]] = {middle, ends[1]};
      ++outer;
    }
  std::vector<int> loop;
  for (int node = next.empty() ? -1 : next.begin()->first; next.contains(node);) {
    const auto [middle, end] = next[node];
    next.erase(node);
    loop.insert(loop.end(), {node, middle});
    node = end;
  }
  if (loop.empty() || loop.size() != 2 * outer)
    throw InputError(mesh.file + ": [mesh] " + key +
                     " selects faces that have no single edge round them; select the tip of one blade alone, or name "
                     "a set of nodes along it as " +
                     (key == "blade_tip" ? "contact" : "contact_splitter"));
  return loop;
}

}  // namespace

std::vector<int> ordered_line(const CellMesh& mesh, std::vector<int> nodes, LeadingEdge leading) {
  const Eigen::Vector2d begin = meridional(mesh, first_of(mesh, nodes, leading));
  std::stable_sort(nodes.begin(), nodes.end(), [&](int a, int b) {
    return (meridional(mesh, a) - begin).norm() < (meridional(mesh, b) - begin).norm();
  });
  return advancing(mesh, nodes);
}

std::vector<int> line_along_tip(const CellMesh& mesh, const std::vector<int>& faces, const std::string& key,
                                LeadingEdge leading) {
  std::vector<int> loop = loop_round(mesh, faces, key);
  std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), first_of(mesh, loop, leading)), loop.end());
  const auto farther = [&](int a, int b) {
    const Eigen::Vector2d begin = meridional(mesh, loop.front());
    return (meridional(mesh, a) - begin).norm() < (meridional(mesh, b) - begin).norm();
  };
  const auto last = std::max_element(loop.begin(), loop.end(), farther);
  std::vector<int> one(loop.begin(), last + 1), other(last, loop.end());
  other.push_back(loop.front());
  std::reverse(other.begin(), other.end());
  one = advancing(mesh, one);
  other = advancing(mesh, other);
  return one.size() >= other.size() ? one : other;
}

}  // namespace tiprub
