// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/sector_mesh.h"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

constexpr int line_2 = 1, line_3 = 8, point = 15, brick_20 = 17, brick_27 = 12;  // gmsh's element types

/// gmsh keeps one model for the whole process: open it, read it, leave nothing behind.
class GmshSession {
 public:
  explicit GmshSession(const std::filesystem::path& path) : file_(path.string()) {
    if (!std::filesystem::is_regular_file(path)) throw RunError(file_ + ": no such file");
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    try {
      gmsh::open(file_);
    } catch (...) {
      gmsh::finalize();
      throw RunError(file_ + ": gmsh can't read it");
    }
  }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
  ~GmshSession() { gmsh::finalize(); }

  struct Elements {
    int type;
    std::vector<std::size_t> nodes;
  };
  /// All elements of a named group, entity by entity.
  std::vector<Elements> group(int dimension, const std::string& name) const {
    std::vector<Elements> found;
    for (const int tag : tags(dimension, name)) {
      std::vector<int> entities;
      gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
      for (const int entity : entities) {
        std::vector<int> types;
        std::vector<std::vector<std::size_t>> elements, nodes;
        gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
        for (std::size_t i = 0; i < types.size(); ++i) found.push_back({types[i], nodes[i]});
      }
    }
    return found;
  }
  const std::string& file() const { return file_; }

 private:
  static std::vector<int> tags(int dimension, const std::string& name) {
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups, dimension);
    std::vector<int> found;
    for (const auto& [group_dimension, tag] : groups) {
      std::string group_name;
      gmsh::model::getPhysicalName(group_dimension, tag, group_name);
      if (group_name == name) found.push_back(tag);
    }
    return found;
  }

  std::string file_;
};

/// gmsh's node tags to our numbers, 0 .. nodes-1 in the order of the tags; only nodes of cells are kept.
class NodeNumbers {
 public:
  explicit NodeNumbers(std::vector<std::size_t> tags) : tags_(std::move(tags)) {
    std::sort(tags_.begin(), tags_.end());
    tags_.erase(std::unique(tags_.begin(), tags_.end()), tags_.end());
  }
  std::size_t count() const { return tags_.size(); }
  int find(std::size_t tag) const {
    const auto at = std::lower_bound(tags_.begin(), tags_.end(), tag);
    return at != tags_.end() && *at == tag ? static_cast<int>(at - tags_.begin()) : -1;
  }

 private:
  std::vector<std::size_t> tags_;
};

std::vector<std::size_t> read_cells(const GmshSession& gmsh_file, int& nodes_per_cell) {
  std::vector<std::size_t> cells;
  nodes_per_cell = 0;
  for (const auto& [type, nodes] : gmsh_file.group(3, "sector")) {
    const int wanted = type == brick_20 ? 20 : type == brick_27 ? 27 : 0;
    if (wanted == 0 || (nodes_per_cell != 0 && wanted != nodes_per_cell))
      throw InputError(gmsh_file.file() + ": volume group \"sector\" holds elements of gmsh type " +
                       std::to_string(type) + "; it must hold 20-node bricks (17) only, or 27-node bricks (12) only");
    nodes_per_cell = wanted;
    cells.insert(cells.end(), nodes.begin(), nodes.end());
  }
  if (cells.empty())
    throw InputError(gmsh_file.file() + ": has no volume group \"sector\" with cells; name it in the mesher");
  return cells;
}

/// The cells of each part of the sector that has a name.
std::map<std::string, std::vector<int>> read_parts(const GmshSession& gmsh_file,
                                                   const std::vector<std::size_t>& cells, int nodes_per_cell) {
  std::map<std::vector<std::size_t>, int> cell_of;  // by its nodes
  for (std::size_t first = 0; first < cells.size(); first += nodes_per_cell)
    cell_of[{cells.begin() + first, cells.begin() + first + nodes_per_cell}] =
        static_cast<int>(first / nodes_per_cell);
  std::map<std::string, std::vector<int>> parts;
  for (const char* name : {"disc", "main_blade", "splitter"})
    for (const auto& [type, nodes] : gmsh_file.group(3, name))
      for (std::size_t first = 0; first + nodes_per_cell <= nodes.size(); first += nodes_per_cell)
        if (const auto at = cell_of.find({nodes.begin() + first, nodes.begin() + first + nodes_per_cell});
            at != cell_of.end())
          parts[name].push_back(at->second);
  return parts;
}

Eigen::Matrix3Xd read_positions(const NodeNumbers& numbers) {
  std::vector<std::size_t> tags;
  std::vector<double> positions, parameters;
  gmsh::model::mesh::getNodes(tags, positions, parameters, -1, -1, false, false);
  Eigen::Matrix3Xd nodes(3, static_cast<Eigen::Index>(numbers.count()));
  for (std::size_t i = 0; i < tags.size(); ++i)
    if (const int node = numbers.find(tags[i]); node >= 0)
      nodes.col(node) = Eigen::Map<const Eigen::Vector3d>(positions.data() + 3 * i);
  return nodes;
}

std::vector<int> read_surface(const GmshSession& gmsh_file, const std::string& name, const NodeNumbers& numbers) {
  std::vector<int> nodes;
  for (const auto& [type, tags] : gmsh_file.group(2, name))
    for (const std::size_t tag : tags) nodes.push_back(numbers.find(tag));
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.empty())
    throw InputError(gmsh_file.file() + ": has no surface group \"" + name + "\"; name it in the mesher");
  if (nodes.front() < 0)
    throw InputError(gmsh_file.file() + ": surface group \"" + name + "\" has nodes that belong to no cell");
  return nodes;
}

/// The nodes of a chain of line elements (or of points) in order.
std::vector<int> read_line(const GmshSession& gmsh_file, const std::string& name, const NodeNumbers& numbers) {
  std::vector<int> nodes;
  auto append = [&](std::size_t tag) {
    const int node = numbers.find(tag);
    if (node < 0) throw InputError(gmsh_file.file() + ": group \"" + name + "\" has nodes that belong to no cell");
    if (nodes.empty() || nodes.back() != node) nodes.push_back(node);
  };
  for (const int dimension : {1, 0}) {
    for (const auto& [type, tags] : gmsh_file.group(dimension, name)) {
      if (type == line_3) {  // end, end, middle
        for (std::size_t i = 0; i + 2 < tags.size(); i += 3)
          for (const std::size_t tag : {tags[i], tags[i + 2], tags[i + 1]}) append(tag);
      } else if (type == line_2 || type == point) {
        for (const std::size_t tag : tags) append(tag);
      }
    }
    if (!nodes.empty()) break;
  }
  if (nodes.empty())
    throw InputError(gmsh_file.file() + ": has no curve or points named \"" + name +
                     "\" (the main blade's tip, from leading to trailing edge); name it in the mesher");
  std::vector<int> sorted = nodes;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    throw InputError(gmsh_file.file() + ": the curve \"" + name + "\" must run once from leading to trailing edge");
  return nodes;
}

double radius(const Eigen::Vector3d& point_at) {
  return std::hypot(point_at.x(), point_at.y());
}

/// N from the angle between a node of the lower face and the nearest one on the upper face with the same r and z.
int count_sectors(const SectorMesh& mesh, const std::string& file) {
  int outermost = mesh.cyclic_low.front();
  for (const int node : mesh.cyclic_low)
    if (radius(mesh.nodes.col(node)) > radius(mesh.nodes.col(outermost))) outermost = node;
  const Eigen::Vector3d low = mesh.nodes.col(outermost);
  const auto distance = [&](int node) {
    const Eigen::Vector3d high = mesh.nodes.col(node);
    return std::hypot(radius(high) - radius(low), high.z() - low.z());
  };
  const int partner = *std::min_element(mesh.cyclic_high.begin(), mesh.cyclic_high.end(),
                                        [&](int a, int b) { return distance(a) < distance(b); });
  const Eigen::Vector3d high = mesh.nodes.col(partner);
  double angle = std::atan2(high.y(), high.x()) - std::atan2(low.y(), low.x());
  if (angle <= 0) angle += 2 * std::numbers::pi;
  const double count = 2 * std::numbers::pi / angle;
  constexpr double whole_number_tolerance = 1e-3;
  if (std::abs(count - std::round(count)) > whole_number_tolerance * count)
    throw InputError(file + ": cyclic_high lies " + std::to_string(angle * 180 / std::numbers::pi) +
                     " degrees after cyclic_low, which is no whole fraction of a turn; re-mesh");
  return static_cast<int>(std::lround(count));
}

/// Orders cyclic_high like cyclic_low. Partners are found by z first, then by distance.
void pair_faces(SectorMesh& mesh, double tolerance, const std::string& file) {
  const double alpha = 2 * std::numbers::pi / mesh.sector_count;
  const double reach = tolerance * mesh.nodes.topRows<2>().colwise().norm().maxCoeff();
  std::multimap<double, int> by_height;
  for (const int node : mesh.cyclic_high) by_height.emplace(mesh.nodes(2, node), node);
  const Eigen::AngleAxisd turn(alpha, Eigen::Vector3d::UnitZ());
  std::vector<int> partners;
  std::size_t alone = 0;
  for (const int low : mesh.cyclic_low) {
    const Eigen::Vector3d target = turn * mesh.nodes.col(low);
    double nearest = reach;
    int partner = -1;
    for (auto at = by_height.lower_bound(target.z() - reach);
         at != by_height.end() && at->first <= target.z() + reach; ++at)
      if (const double gap = (mesh.nodes.col(at->second) - target).norm(); gap <= nearest) {
        nearest = gap;
        partner = at->second;
      }
    if (partner < 0) ++alone;
    partners.push_back(partner);
    mesh.pairing_mismatch = std::max(mesh.pairing_mismatch, partner < 0 ? 0.0 : nearest);
  }
  if (alone > 0 || mesh.cyclic_low.size() != mesh.cyclic_high.size())
    throw InputError(file + ": " + std::to_string(alone) + " of " + std::to_string(mesh.cyclic_low.size()) +
                     " nodes on cyclic_low have no partner among the " + std::to_string(mesh.cyclic_high.size()) +
                     " on cyclic_high, turned by 360/" + std::to_string(mesh.sector_count) +
                     " degrees, within tolerance; re-mesh, or raise [reduce] cyclic_tolerance");
  mesh.cyclic_high = partners;
}

}  // namespace

SectorMesh read_sector_mesh(const std::filesystem::path& path, double tolerance) {
  const GmshSession gmsh_file(path);
  int nodes_per_cell = 0;
  const std::vector<std::size_t> cells = read_cells(gmsh_file, nodes_per_cell);
  const NodeNumbers numbers(cells);
  SectorMesh mesh;
  mesh.nodes = read_positions(numbers);
  mesh.cells.resize(nodes_per_cell, static_cast<Eigen::Index>(cells.size()) / nodes_per_cell);
  for (std::size_t i = 0; i < cells.size(); ++i) mesh.cells.data()[i] = numbers.find(cells[i]);
  mesh.parts = read_parts(gmsh_file, cells, nodes_per_cell);
  mesh.cyclic_low = read_surface(gmsh_file, "cyclic_low", numbers);
  mesh.cyclic_high = read_surface(gmsh_file, "cyclic_high", numbers);
  mesh.clamped = read_surface(gmsh_file, "clamped", numbers);
  mesh.contact_line = read_line(gmsh_file, "contact", numbers);
  mesh.sector_count = count_sectors(mesh, gmsh_file.file());
  pair_faces(mesh, tolerance, gmsh_file.file());
  return mesh;
}

}  // namespace tiprub
