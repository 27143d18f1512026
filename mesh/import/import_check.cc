// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/import_check.h"

#include <algorithm>
#include <array>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "cases/program/errors.h"
#include "cases/program/text.h"

namespace tiprub::mesh {

namespace {

/// Which nodes hang together, also through the cuts; each body by one of its nodes.
using Bodies = boost::disjoint_sets_with_storage<>;

Bodies bodies_of(const CellMesh& mesh, const PeriodicCuts& pairs) {
  Bodies bodies(static_cast<std::size_t>(mesh.nodes.cols()));
  for (const std::vector<int>& cell : mesh.cells)
    for (const int node : cell) bodies.union_set(node, cell.front());
  const auto node_of = [&](int face) { return mesh.faces[face].nodes.front(); };
  for (std::size_t k = 0; k < pairs.low.size(); ++k) bodies.union_set(node_of(pairs.low[k]), node_of(pairs.high[k]));
  return bodies;
}

/// The smallest and the largest radius of nodes [m].
std::array<double, 2> radii_of(const CellMesh& mesh, const std::vector<int>& nodes) {
  const Eigen::VectorXd radii = mesh.nodes(Eigen::seqN(0, 2), nodes).colwise().norm();
  return {radii.minCoeff(), radii.maxCoeff()};
}

/// How many faces lie beyond the first node of a line, see require_along_tip().
int faces_beyond(const CellMesh& mesh, const std::vector<int>& faces, const std::vector<int>& line) {
  constexpr double round_edge = 0.05, of_a_face = 0.5;
  const Eigen::Vector3d end = mesh.nodes.col(line[0]), outward = (end - mesh.nodes.col(line[1])).normalized();
  const double length = (end - mesh.nodes.col(line.back())).norm();
  return static_cast<int>(std::ranges::count_if(faces, [&](int number) {
    const FreeFace& face = mesh.faces[number];
    std::vector<double> reach;
    for (std::size_t k = 0; k < face.corners(); ++k)
      reach.push_back(outward.dot(mesh.nodes.col(face.nodes[k]) - end));
    const auto [low, high] = std::ranges::minmax_element(reach);
    const auto distance = [&](int node) { return (mesh.nodes.col(node) - mesh.nodes.col(face.nodes[0])).norm(); };
    const bool at_end = std::ranges::all_of(line, [&](int node) { return distance(node) >= distance(line[0]); });
    return at_end && *low > of_a_face * (*high - *low) && *low > round_edge * length;
  }));
}

Eigen::Vector2d meridional(const Eigen::Vector3d& place) {
  return {place.head<2>().norm(), place.z()};
}

/// The share of the area of a tip that lies beyond the ends of a line, in the meridional plane: of faces whose centre
/// is beyond an end, where the line goes on straight.
double share_beyond(const CellMesh& mesh, const std::vector<int>& faces, const std::vector<int>& line) {
  constexpr double at_the_end = 1e-6;  // of the line's last step: a face with its centre there is not beyond
  std::vector<Eigen::Vector2d> way;
  for (const int node : line) way.push_back(meridional(mesh.nodes.col(node)));
  double beyond = 0, all = 0;
  for (const int number : faces) {
    const Eigen::Vector2d at = meridional(centre(mesh, mesh.faces[number]));
    const auto nearer = [&](const auto& a, const auto& b) { return (a - at).norm() < (b - at).norm(); };
    const auto nearest = std::ranges::min_element(way, nearer);
    const auto is_beyond = [&](const Eigen::Vector2d& end, const Eigen::Vector2d& before) {
      return *nearest == end && (at - end).dot(end - before) > at_the_end * (end - before).squaredNorm();
    };
    all += area(mesh, mesh.faces[number]);
    if (is_beyond(way.front(), way[1]) || is_beyond(way.back(), way[way.size() - 2]))
      beyond += area(mesh, mesh.faces[number]);
  }
  return beyond / all;
}

}  // namespace

std::string extent_of(const CellMesh& mesh, const std::vector<int>& faces) {
  constexpr double one_radius = 1e-4;  // of the largest radius
  std::vector<int> nodes;
  for (const int face : faces)
    nodes.insert(nodes.end(), mesh.faces[face].nodes.begin(), mesh.faces[face].nodes.end());
  const auto [low, high] = radii_of(mesh, nodes);
  const std::string range =
      high - low > one_radius * mesh.largest_radius() ? text_of(low, " to ", high) : text_of(low);
  return text_of(faces.size(), faces.size() == 1 ? " face" : " faces", ", r ", range, " m");
}

bool goes_round(const CellMesh& mesh) {
  constexpr double on_the_axis = 1e-6;  // of the largest radius
  const double least = on_the_axis * mesh.largest_radius();
  std::vector<double> angles;
  for (const auto& node : mesh.nodes.colwise())
    if (node.head<2>().norm() > least) angles.push_back(std::atan2(node.y(), node.x()));
  std::ranges::sort(angles);
  double gap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t k = 1; k < angles.size(); ++k) gap = std::max(gap, angles[k] - angles[k - 1]);
  return gap < std::numbers::pi / 2;
}

void require_held(const CellMesh& mesh, const PeriodicCuts& pairs, const std::vector<int>& clamped) {
  Bodies bodies = bodies_of(mesh, pairs);
  std::set<int> all, held;
  for (const std::vector<int>& cell : mesh.cells) all.insert(bodies.find_set(cell.front()));
  for (const int face : clamped) held.insert(bodies.find_set(mesh.faces[face].nodes.front()));
  const auto loose = std::ranges::find_if(all, [&](int body) { return !held.contains(body); });
  if (loose == all.end()) return;
  std::vector<int> nodes;
  for (int node = 0; node < mesh.nodes.cols(); ++node)
    if (bodies.find_set(node) == *loose) nodes.push_back(node);
  const auto [low, high] = radii_of(mesh, nodes);
  const auto cells =
      std::ranges::count_if(mesh.cells, [&](const auto& cell) { return bodies.find_set(cell.front()) == *loose; });
  throw InputError(
      text_of(mesh.file, ": the cells form ", all.size(), " bodies that share no node: one of ", cells,
              " cells, with r from ", low, " to ", high,
              " m, touches nothing that is clamped; join the volumes before meshing (gmsh: BooleanFragments)"));
}

std::vector<int> off_the_cuts(const CellMesh& mesh, const PeriodicCuts& cuts, const std::vector<int>& clamped) {
  std::set<int> cut(cuts.low.begin(), cuts.low.end());
  cut.insert(cuts.high.begin(), cuts.high.end());
  std::vector<int> off, on;
  for (const int face : clamped) (cut.contains(face) ? on : off).push_back(face);
  const auto edges = faces_at_edges(mesh.faces, off);
  const bool meant = std::ranges::any_of(on, [&](int number) {
    const FreeFace& face = mesh.faces[number];
    int held = 0;
    for (std::size_t k = 0; k < face.corners(); ++k) held += edges.contains(face.edge(k)) ? 1 : 0;
    return held < 2;
  });
  if (meant || (!on.empty() && on.size() == cut.size()))
    throw InputError(
        text_of(mesh.file, ": [mesh] clamped selects ", on.size(), on.size() == 1 ? " face" : " faces",
                " of the cuts, inside the wheel; select the surface by which the wheel is held, as the bore"));
  return off;
}

void require_one_surface(const CellMesh& mesh, const std::vector<int>& faces, const std::string& key) {
  constexpr double sharp_cosine = 0.5;  // of 60 degrees
  const auto edges = faces_at_edges(mesh.faces, faces);
  for (const auto& [edge, at] : edges)
    if (mesh.faces[at.front()].normal.dot(mesh.faces[at.back()].normal) < sharp_cosine)
      throw InputError(mesh.file + ": [mesh] " + key + " selects faces on both sides of a sharp edge, at " +
                       mesh.place_of(edge[0]) + "; select the tip alone, without the flanks of the blade");
  std::set<int> seen = {faces.front()};
  for (std::vector<int> front = {faces.front()}; !front.empty();) {
    const FreeFace& face = mesh.faces[front.back()];
    front.pop_back();
    for (std::size_t k = 0; k < face.corners(); ++k)
      for (const int next : edges.at(face.edge(k)))
        if (seen.insert(next).second) front.push_back(next);
  }
  if (seen.size() < faces.size())
    throw InputError(text_of(mesh.file, ": [mesh] ", key, " selects surfaces that share no edge, one of ",
                             seen.size(), " of the ", faces.size(), " faces; select the tip of one blade alone"));
}

void require_one_line(const CellMesh& mesh, const std::vector<int>& nodes, const std::vector<int>& line,
                      const std::string& key) {
  const auto refuse = [&](int node) {
    throw InputError(mesh.file + ": [mesh] " + key + " has nodes side by side across the tip, at " +
                     mesh.place_of(node) + "; name nodes along one line of the tip, as its middle");
  };
  const std::set<int> kept(line.begin(), line.end());
  for (const int node : nodes)
    if (!kept.contains(node)) refuse(node);
  const auto step = [&](std::size_t k) -> Eigen::Vector3d {
    return mesh.nodes.col(line[k]) - mesh.nodes.col(line[k - 1]);
  };
  for (std::size_t k = 1; k + 1 < line.size(); ++k)
    if (step(k).dot(step(k + 1)) < 0) refuse(line[k]);
}

void require_along_tip(const CellMesh& mesh, const std::vector<int>& faces, const std::string& faces_key,
                       const std::vector<int>& line, const std::string& line_key) {
  constexpr double most_beyond = 0.3;  // of the tip's area; tiprub-reduce has the same limit
  const char* whole = "; the line must run from the leading to the trailing edge";
  std::set<int> nodes;
  for (const int face : faces) nodes.insert(mesh.faces[face].nodes.begin(), mesh.faces[face].nodes.end());
  const auto off = std::ranges::count_if(line, [&](int node) { return !nodes.contains(node); });
  const std::string keys = mesh.file + ": [mesh] " + line_key + " and " + faces_key;
  if (off > 0)
    throw InputError(text_of(keys, " don't belong together: ", off, " of the ", line.size(), " nodes of ", line_key,
                             " are not on the faces of ", faces_key, "; name the line and the faces of one tip"));
  const std::vector<int> reversed(line.rbegin(), line.rend());
  for (const std::vector<int>* way : {&line, &reversed})
    if (const int beyond = faces_beyond(mesh, faces, *way); beyond > 0)
      throw InputError(text_of(keys, " don't belong together: ", beyond, " faces of ", faces_key,
                               " lie beyond the end of ", line_key, " at ", mesh.place_of(way->front()), whole));
  if (const double beyond = share_beyond(mesh, faces, line); beyond > most_beyond)
    throw InputError(text_of(keys, " don't belong together: ", std::lround(100 * beyond), " % of the area of ",
                             faces_key, " lies beyond the ends of ", line_key, whole));
}

}  // namespace tiprub::mesh
