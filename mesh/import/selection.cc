// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/selection.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

constexpr double tolerance = 1e-4;  // of the largest radius
constexpr double most_degrees = 5;  // between normals

using IsIn = std::function<bool(const FreeFace&)>;

[[noreturn]] void refuse(const CellMesh& mesh, const std::string& key, const std::string& message) {
  throw InputError(mesh.file + ": [mesh] " + key + " " + message);
}

template <class Sets>
const std::vector<int>& set_of(const CellMesh& mesh, const Sets& sets, const std::string& key,
                               const std::string& name, const std::string& what) {
  const auto known = sets.find(name);
  if (known != sets.end() && !known->second.empty()) return known->second;
  std::string names;
  for (const auto& [each, members] : sets)
    if (!members.empty()) names += (names.empty() ? "" : ", ") + each;
  refuse(mesh, key,
         "= \"" + name + "\": there is no set of this name " + what +
             "; there are: " + (names.empty() ? "none" : names));
}

IsIn every_corner(const std::function<bool(int)>& is_in) {
  return [is_in](const FreeFace& face) {
    return std::all_of(face.nodes.begin(), face.nodes.begin() + static_cast<std::ptrdiff_t>(face.corners()), is_in);
  };
}

/// What is selected by geometry, or nothing if the words are none of these.
IsIn by_geometry(const CellMesh& mesh, const std::string& key, const std::string& selection) {
  std::istringstream words(selection);
  std::string kind, axis;
  words >> kind;
  const double reach = tolerance * mesh.largest_radius();
  const auto numbers = [&](Eigen::Ref<Eigen::VectorXd> values) {
    for (double& value : values)
      if (!(words >> value)) refuse(mesh, key, "= \"" + selection + "\" lacks a number");
    if (std::string more; words >> more) refuse(mesh, key, "= \"" + selection + "\" goes on after its numbers");
  };
  if (kind == "cylinder") {
    Eigen::VectorXd radius(1);
    numbers(radius);
    return every_corner([&mesh, reach, r = radius[0]](int node) {
      return std::abs(mesh.nodes.col(node).head<2>().norm() - r) <= reach;
    });
  }
  if (kind == "plane") {
    words >> axis;
    const std::size_t along = std::string("xyz").find(axis);
    if (axis.size() != 1 || along == std::string::npos)
      refuse(mesh, key, "= \"" + selection + "\" must be plane x, y or z and a place");
    Eigen::VectorXd place(1);
    numbers(place);
    return every_corner([&mesh, reach, along, at = place[0]](int node) {
      return std::abs(mesh.nodes(static_cast<Eigen::Index>(along), node) - at) <= reach;
    });
  }
  if (kind == "normal") {
    Eigen::VectorXd normal(3);
    numbers(normal);
    const Eigen::Vector3d unit = normal.normalized();
    const double least = std::cos(most_degrees * std::numbers::pi / 180);
    return [unit, least](const FreeFace& face) { return face.normal.dot(unit) >= least; };
  }
  return {};
}

}  // namespace

const std::vector<int>& select_nodes(const CellMesh& mesh, const std::string& key, const std::string& name) {
  return set_of(mesh, mesh.node_sets, key, name, "with nodes of solids");
}

const std::vector<int>& select_cells(const CellMesh& mesh, const std::string& key, const std::string& name) {
  return set_of(mesh, mesh.cell_sets, key, name, "with solids");
}

std::vector<int> select_faces(const CellMesh& mesh, const std::string& key, const std::string& selection) {
  IsIn is_in = by_geometry(mesh, key, selection);
  if (!is_in) {
    std::vector<char> marked(static_cast<std::size_t>(mesh.nodes.cols()), 0);
    for (const int node : select_nodes(mesh, key, selection)) marked[static_cast<std::size_t>(node)] = 1;
    is_in = every_corner([marked](int node) { return marked[static_cast<std::size_t>(node)] != 0; });
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

}  // namespace tiprub
