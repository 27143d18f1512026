// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/import_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "cases/program/errors.h"
#include "cases/program/text.h"

namespace tiprub::mesh {

namespace {

/// Which nodes hang together, each body by one of its nodes.
class Bodies {
 public:
  Bodies(const CellMesh& mesh, const PeriodicCuts& pairs) : next_(static_cast<std::size_t>(mesh.nodes.cols())) {
    std::iota(next_.begin(), next_.end(), 0);
    for (const std::vector<int>& cell : mesh.cells)
      for (const int node : cell) join(node, cell.front());
    const auto node_of = [&](int face) { return mesh.faces[static_cast<std::size_t>(face)].nodes.front(); };
    for (std::size_t k = 0; k < pairs.low.size(); ++k) join(node_of(pairs.low[k]), node_of(pairs.high[k]));
  }

  int of(int node) {
    while (next(node) != node) node = next(node) = next(next(node));
    return node;
  }

 private:
  int& next(int node) { return next_[static_cast<std::size_t>(node)]; }
  void join(int one, int other) { next(of(one)) = of(other); }

  std::vector<int> next_;  // by node; the one that stands for the body is its own
};

/// The largest angle about the axis [rad] without a node.
double largest_gap(const CellMesh& mesh) {
  constexpr double on_the_axis = 1e-6;  // of the largest radius
  const double least = on_the_axis * mesh.largest_radius();
  std::vector<double> angles;
  for (const auto& node : mesh.nodes.colwise())
    if (node.head<2>().norm() > least) angles.push_back(std::atan2(node.y(), node.x()));
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t k = 1; k < angles.size(); ++k) gap = std::max(gap, angles[k] - angles[k - 1]);
  return gap;
}

bool goes_round(const CellMesh& mesh) {
  return largest_gap(mesh) < std::numbers::pi / 2;
}

}  // namespace

std::string extent_of(const CellMesh& mesh, const std::vector<int>& faces) {
  constexpr double one_radius = 1e-4;  // of the largest radius
  double low = mesh.largest_radius(), high = 0;
  for (const int face : faces)
    for (const int node : mesh.faces[static_cast<std::size_t>(face)].nodes) {
      low = std::min(low, mesh.nodes.col(node).head<2>().norm());
      high = std::max(high, mesh.nodes.col(node).head<2>().norm());
    }
  const std::string range =
      high - low > one_radius * mesh.largest_radius() ? text_of(low, " to ", high) : text_of(low);
  return text_of(faces.size(), faces.size() == 1 ? " face" : " faces", ", r ", range, " m");
}

std::string doubt_about_cuts(const CellMesh& mesh, const PeriodicCuts& cuts) {
  if (!goes_round(mesh)) return "";
  return "the mesh goes round the axis, and its faces that were taken for cuts may be the flanks of blades; set "
         "[mesh] "
         "sector_count = 1 if it is a whole wheel, or " +
         std::to_string(cuts.sector_count) + " if it is a sector";
}

std::string doubt_about_one_body(const CellMesh& mesh) {
  if (goes_round(mesh)) return "";
  return "no face, turned about the axis, is another one, so that this is one body without neighbours; if it is a "
         "sector, mesh both cuts alike (gmsh: Periodic Surface), else set [mesh] sector_count = 1";
}

void require_held(const CellMesh& mesh, const PeriodicCuts& pairs, const std::vector<int>& clamped) {
  Bodies bodies(mesh, pairs);
  std::set<int> all, held;
  for (const std::vector<int>& cell : mesh.cells) all.insert(bodies.of(cell.front()));
  for (const int face : clamped) held.insert(bodies.of(mesh.faces[static_cast<std::size_t>(face)].nodes.front()));
  const auto loose = std::find_if(all.begin(), all.end(), [&](int body) { return !held.contains(body); });
  if (loose == all.end()) return;
  double low = mesh.largest_radius(), high = 0;
  for (int node = 0; node < mesh.nodes.cols(); ++node)
    if (bodies.of(node) == *loose) {
      low = std::min(low, mesh.nodes.col(node).head<2>().norm());
      high = std::max(high, mesh.nodes.col(node).head<2>().norm());
    }
  const auto cells = std::count_if(mesh.cells.begin(), mesh.cells.end(),
                                   [&](const auto& cell) { return bodies.of(cell.front()) == *loose; });
  throw InputError(
      text_of(mesh.file, ": the cells form ", all.size(), " bodies that share no node: one of ", cells,
              " cells, with r from ", low, " to ", high,
              " m, touches nothing that is clamped; join the volumes before meshing (gmsh: BooleanFragments)"));
}

}  // namespace tiprub::mesh
