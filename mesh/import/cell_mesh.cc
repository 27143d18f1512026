// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/cell_mesh.h"

#include <Eigen/Geometry>
#include <set>

#include "cases/program/errors.h"
#include "cases/program/text.h"

namespace tiprub::mesh {

namespace {

class Translation {
 public:
  Translation(const ForeignMesh& from, double length, Axis axis) : from_(from), length_(length), axis_(axis) {
    made_.file = from.file;
    made_.upper_names = from.upper_names;
  }

  CellMesh run() {
    if (from_.cells.empty())
      throw InputError(from_.file + ": holds no quadratic solid elements; is it the file of the mesh?");
    for (const ForeignCell& cell : from_.cells) add(cell);
    if (const auto [first, second] = equal_cells(made_.cells); first >= 0)
      throw InputError(from_.file + ": elements " + std::to_string(number_of(first)) + " and " +
                       std::to_string(number_of(second)) +
                       " have the same nodes; is the mesh there twice? Write it once");
    made_.nodes.resize(3, static_cast<Eigen::Index>(places_.size()));
    for (std::size_t k = 0; k < places_.size(); ++k) made_.nodes.col(static_cast<Eigen::Index>(k)) = places_[k];
    made_.faces = free_faces(made_.nodes, made_.cells);
    for (const auto& [name, numbers] : from_.node_sets) made_.node_sets[name] = known(numbers);
    for (const auto& [name, numbers] : from_.surfaces) {
      made_.surfaces[name] = known(numbers);
      made_.node_sets.try_emplace(name, made_.surfaces[name]);
    }
    for (const auto& [name, numbers] : from_.cell_sets) add_cell_set(name, numbers);
    return std::move(made_);
  }

 private:
  long number_of(int cell) const { return from_.cells[static_cast<std::size_t>(cell)].number; }

  void add(const ForeignCell& cell) {
    if (!cell_of_.emplace(cell.number, static_cast<int>(made_.cells.size())).second)
      throw InputError(from_.file + ": element " + std::to_string(cell.number) + " is there twice");
    std::vector<int> nodes;
    for (const long number : cell.nodes) nodes.push_back(node(number, cell.number));
    if (std::set(nodes.begin(), nodes.end()).size() != nodes.size())
      throw InputError(from_.file + ": element " + std::to_string(cell.number) + " has a node twice");
    made_.cells.push_back(nodes);
  }

  int node(long number, long cell) {
    if (const auto known = node_of_.find(number); known != node_of_.end()) return known->second;
    const auto at = from_.nodes.find(number);
    if (at == from_.nodes.end())
      throw InputError(from_.file + ": element " + std::to_string(cell) + " names node " + std::to_string(number) +
                       ", which isn't there");
    const Eigen::Vector3d& p = at->second;
    const Eigen::Vector3d turned = axis_ == Axis::x   ? Eigen::Vector3d(p.y(), p.z(), p.x())
                                   : axis_ == Axis::y ? Eigen::Vector3d(p.z(), p.x(), p.y())
                                                      : p;
    constexpr double farthest = 1000;  // [m] no wheel reaches so far
    if (!(length_ * turned.norm() < farthest))
      throw InputError(from_.file + ": node " + std::to_string(number) + " stands more than " +
                       std::to_string(static_cast<int>(farthest)) + " m from the origin; is length_unit right?");
    places_.emplace_back(length_ * turned);
    return node_of_[number] = static_cast<int>(places_.size()) - 1;
  }

  std::vector<int> known(const std::vector<long>& numbers) const {
    std::vector<int> nodes;
    std::set<int> seen;
    for (const long number : numbers)
      if (const auto at = node_of_.find(number); at != node_of_.end() && seen.insert(at->second).second)
        nodes.push_back(at->second);
    return nodes;
  }

  void add_cell_set(const std::string& name, const std::vector<long>& numbers) {
    std::vector<long> nodes;
    bool solids_only = true;
    for (const long number : numbers) {
      if (const auto cell = cell_of_.find(number); cell != cell_of_.end()) {
        made_.cell_sets[name].push_back(cell->second);
        const std::vector<long>& of_cell = from_.cells[static_cast<std::size_t>(cell->second)].nodes;
        nodes.insert(nodes.end(), of_cell.begin(), of_cell.end());
      } else if (const auto other = from_.others.find(number); other != from_.others.end()) {
        nodes.insert(nodes.end(), other->second.begin(), other->second.end());
        solids_only = false;
      }
    }
    const bool is_new = made_.node_sets.try_emplace(name, known(nodes)).second;
    if (is_new && solids_only && !made_.node_sets[name].empty()) made_.sets_of_solids.insert(name);
  }

  const ForeignMesh& from_;
  double length_;
  Axis axis_;
  CellMesh made_;
  std::vector<Eigen::Vector3d> places_;
  std::map<long, int> node_of_, cell_of_;
};

}  // namespace

std::string CellMesh::set_named(const std::string& name) const {
  const std::string other = upper(name);
  return upper_names && !node_sets.contains(name) && node_sets.contains(other) ? other : name;
}

std::string CellMesh::place_of(int node) const {
  return text_of("x y z = ", nodes(0, node), " ", nodes(1, node), " ", nodes(2, node), " m");
}

Eigen::Vector3d centre(const CellMesh& mesh, const FreeFace& face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < face.corners(); ++k) sum += mesh.nodes.col(face.nodes[k]);
  return sum / static_cast<double>(face.corners());
}

double area(const CellMesh& mesh, const FreeFace& face) {
  const auto edge = [&](std::size_t k) -> Eigen::Vector3d {
    return mesh.nodes.col(face.nodes[k]) - mesh.nodes.col(face.nodes[0]);
  };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 2; k < face.corners(); ++k) sum += edge(k - 1).cross(edge(k));
  return 0.5 * sum.norm();
}

CellMesh in_our_terms(const ForeignMesh& mesh, double length, Axis axis) {
  return Translation(mesh, length, axis).run();
}

}  // namespace tiprub::mesh
