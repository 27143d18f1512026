// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/selection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "cases/program/errors.h"
#include "cases/program/text.h"

namespace tiprub::mesh {

namespace {

constexpr double selection_tolerance = 1e-4;  // of the largest radius
constexpr double most_degrees = 5;            // between normals

using IsIn = std::function<bool(const FreeFace&)>;

[[noreturn]] void refuse(const CellMesh& mesh, const std::string& key, const std::string& message) {
  throw InputError(mesh.file + ": [mesh] " + key + " " + message);
}

std::string names_in(const std::map<std::string, std::vector<int>>& sets) {
  const std::string names =
      listed(sets, ", ", [](const auto& set) { return set.second.empty() ? std::string() : set.first; });
  return names.empty() ? "none" : names;
}

const std::vector<int>& set_of(const CellMesh& mesh, const std::map<std::string, std::vector<int>>& sets,
                               const std::string& key, const std::string& name, const std::string& what) {
  const auto known = sets.find(name);
  if (known != sets.end() && !known->second.empty()) return known->second;
  refuse(mesh, key, "= \"" + name + "\": there is no set of this name " + what + "; there are: " + names_in(sets));
}

IsIn every_corner(const std::function<bool(int)>& is_in) {
  return [is_in](const FreeFace& face) {
    return std::all_of(face.nodes.begin(), face.nodes.begin() + static_cast<std::ptrdiff_t>(face.corners()), is_in);
  };
}

/// The selection by geometry that the words describe, or nothing if they are the name of a set.
IsIn by_geometry(const CellMesh& mesh, const std::string& key, const std::string& selection) {
  std::istringstream words(selection);
  std::string kind, axis;
  words >> kind;
  const double reach = selection_tolerance * mesh.largest_radius();
  const auto numbers = [&](std::size_t count) {
    const std::vector<double> values(std::istream_iterator<double>(words), {});
    if (values.size() < count) refuse(mesh, key, "= \"" + selection + "\" lacks a number");
    if (values.size() > count || !words.eof()) refuse(mesh, key, "= \"" + selection + "\" goes on after its numbers");
    return values;
  };
  if (kind == "cylinder") {
    return every_corner([&mesh, reach, r = numbers(1)[0]](int node) {
      return std::abs(mesh.nodes.col(node).head<2>().norm() - r) <= reach;
    });
  }
  if (kind == "plane") {
    words >> axis;
    const std::size_t along = std::string("xyz").find(axis);
    if (axis.size() != 1 || along == std::string::npos)
      refuse(mesh, key, "= \"" + selection + "\" must be plane x, y or z and a place");
    return every_corner([&mesh, reach, along, at = numbers(1)[0]](int node) {
      return std::abs(mesh.nodes(static_cast<Eigen::Index>(along), node) - at) <= reach;
    });
  }
  if (kind == "normal") {
    const Eigen::Vector3d normal(numbers(3).data());
    if (normal.isZero(0))
      refuse(mesh, key, "= \"" + selection + "\" has no direction; give a vector that is not zero");
    const Eigen::Vector3d unit = normal.normalized();
    const double least = std::cos(most_degrees * std::numbers::pi / 180);
    return [unit, least](const FreeFace& face) { return face.normal.dot(unit) >= least; };
  }
  return {};
}

constexpr double least_step = 1e-4;      // of the line's length
constexpr double corner_degrees = 60;    // between two steps along the edge of a tip
constexpr double most_of_an_end = 0.25;  // of a way along the edge: a longer stretch is a flank

Eigen::Vector2d meridional(const CellMesh& mesh, int node) {
  return {mesh.nodes.col(node).head<2>().norm(), mesh.nodes(2, node)};
}

int first_of(const CellMesh& mesh, const std::vector<int>& nodes, LeadingEdge leading) {
  const double sign = leading == LeadingEdge::low_z ? 1 : -1, same = 1e-9 * mesh.largest_radius();
  return *std::ranges::min_element(nodes, [&](int a, int b) {
    const Eigen::Vector2d at = meridional(mesh, a), other = meridional(mesh, b);
    return std::abs(at[1] - other[1]) > same ? sign * at[1] < sign * other[1] : at[0] < other[0];
  });
}

/// [m] From one node to another in the meridional plane.
auto distance_from(const CellMesh& mesh, int first) {
  return [&mesh, begin = meridional(mesh, first)](int node) { return (meridional(mesh, node) - begin).norm(); };
}

/// The nodes of a path that lie farther from its first node than all before them.
std::vector<int> advancing(const CellMesh& mesh, const std::vector<int>& way) {
  const auto distance = distance_from(mesh, way.front());
  double length = 0;
  for (const int node : way) length = std::max(length, distance(node));
  std::vector<int> kept = {way.front()};
  for (const int node : way)
    if (distance(node) > distance(kept.back()) + least_step * length) kept.push_back(node);
  return kept;
}

/// The nodes on the outer edge of the faces, mid-side nodes included.
std::vector<int> loop_round(const CellMesh& mesh, const std::vector<int>& faces, const std::string& key) {
  std::map<std::array<int, 2>, int> directed;  // the middle, by the ends of an edge in the face's direction
  for (const int f : faces) {
    const FreeFace& face = mesh.faces[f];
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

/// A way along the edge of a tip without the blunt ends that it goes across: the stretches beyond its first and its
/// last corner, where these are short.
std::vector<int> along_flank(const CellMesh& mesh, const std::vector<int>& way) {
  const double least_cosine = std::cos(corner_degrees * std::numbers::pi / 180);
  const auto step = [&](std::size_t k) -> Eigen::Vector3d {
    return mesh.nodes.col(way[k]) - mesh.nodes.col(way[k - 1]);
  };
  double whole = 0, length = 0;
  for (std::size_t k = 1; k < way.size(); ++k) whole += step(k).norm();
  std::size_t first = 0, last = way.size() - 1;
  for (std::size_t k = 1; k < last; ++k) {
    length += step(k).norm();
    if (step(k).normalized().dot(step(k + 1).normalized()) >= least_cosine) continue;
    if (length < most_of_an_end * whole) first = k;
    if (length > (1 - most_of_an_end) * whole) last = k;
  }
  return {way.begin() + static_cast<std::ptrdiff_t>(first), way.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

}  // namespace

const std::vector<int>& select_nodes(const CellMesh& mesh, const std::string& key, const std::string& name) {
  return set_of(mesh, mesh.node_sets, key, name, "with nodes of solids");
}

const std::vector<int>& select_cells(const CellMesh& mesh, const std::string& key, const std::string& name) {
  return set_of(mesh, mesh.cell_sets, key, name, "with solids");
}

std::string names_of_sets(const CellMesh& mesh) {
  return names_in(mesh.node_sets);
}

std::vector<int> select_faces(const CellMesh& mesh, const std::string& key, const std::string& selection) {
  IsIn is_in = by_geometry(mesh, key, selection);
  if (!is_in) {
    const auto surface = mesh.surfaces.find(selection);
    const bool is_surface = surface != mesh.surfaces.end() && !surface->second.empty();
    if (!is_surface && mesh.sets_of_solids.contains(selection))
      refuse(mesh, key,
             "= \"" + selection +
                 "\" is a set of solids, not of faces; name the set of the faces or of their nodes, or select them "
                 "by cylinder, plane or normal");
    const std::vector<int>& nodes = is_surface ? surface->second : select_nodes(mesh, key, selection);
    is_in = every_corner([set = std::set(nodes.begin(), nodes.end())](int node) { return set.contains(node); });
  }
  std::vector<int> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (is_in(mesh.faces[f])) faces.push_back(static_cast<int>(f));
  if (faces.empty())
    refuse(mesh, key,
           "= \"" + selection + "\" selects no face of the surface, of a radius up to " +
               std::to_string(mesh.largest_radius()) + " m; is length_unit right?");
  return faces;
}

std::vector<int> ordered_line(const CellMesh& mesh, std::vector<int> nodes, LeadingEdge leading) {
  std::ranges::stable_sort(nodes, {}, distance_from(mesh, first_of(mesh, nodes, leading)));
  return advancing(mesh, nodes);
}

std::vector<int> line_along_tip(const CellMesh& mesh, const std::vector<int>& faces, const std::string& key,
                                LeadingEdge leading) {
  std::vector<int> loop = loop_round(mesh, faces, key);
  std::rotate(loop.begin(), std::ranges::find(loop, first_of(mesh, loop, leading)), loop.end());
  const auto last = std::ranges::max_element(loop, {}, distance_from(mesh, loop.front()));
  std::vector<int> one(loop.begin(), last + 1), other(last, loop.end());
  other.push_back(loop.front());
  std::ranges::reverse(other);
  one = advancing(mesh, along_flank(mesh, one));
  other = advancing(mesh, along_flank(mesh, other));
  return one.size() >= other.size() ? one : other;
}

}  // namespace tiprub::mesh
