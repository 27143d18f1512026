// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/cell_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <sstream>

#include "cases/program/errors.h"
#include "mesh/cells/cell_kind.h"

namespace tiprub {

namespace {

class Translation {
 public:
  Translation(const ForeignMesh& from, double length, Axis axis) : from_(from), length_(length), axis_(axis) {
    made_.file = from.file;
  }

  CellMesh run() {
    if (from_.cells.empty())
      throw InputError(from_.file + ": holds no quadratic solid elements; is it the file of the mesh?");
    for (const ForeignCell& cell : from_.cells) add(cell);
    made_.nodes.resize(3, static_cast<Eigen::Index>(places_.size()));
    for (std::size_t k = 0; k < places_.size(); ++k) made_.nodes.col(static_cast<Eigen::Index>(k)) = places_[k];
    add_free_faces();
    for (const auto& [name, numbers] : from_.node_sets) made_.node_sets[name] = known(numbers);
    for (const auto& [name, numbers] : from_.cell_sets) add_cell_set(name, numbers);
    return std::move(made_);
  }

 private:
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

  void add_free_faces() {
    std::map<std::vector<int>, std::pair<FreeFace, int>> faces;  // by their corners
    for (const std::vector<int>& cell : made_.cells) {
      const CellKind& kind = cell_kind(static_cast<int>(cell.size()));
      for (const std::vector<int>& around : kind.faces) {
        FreeFace face;
        for (const int corner : around) face.nodes.push_back(cell[corner]);
        std::vector<int> key = face.nodes;
        std::sort(key.begin(), key.end());
        for (std::size_t k = 0; k < around.size(); ++k)
          face.nodes.push_back(cell[kind.middle_of(around[k], around[(k + 1) % around.size()])]);
        ++faces.try_emplace(key, face, 0).first->second.second;
      }
    }
    for (auto& [key, found] : faces) {
      if (found.second > 1) continue;
      FreeFace& face = found.first;
      const auto at = [&](std::size_t k) -> Eigen::Vector3d { return made_.nodes.col(face.nodes[k]); };
      const std::size_t last = face.corners() - 1;
      face.normal = (at(1) - at(0)).cross(at(last) - at(0)) + (at(last) - at(last - 1)).cross(at(1) - at(last - 1));
      if (last == 2) face.normal = (at(1) - at(0)).cross(at(2) - at(0));
      face.normal.normalize();
      made_.faces.push_back(face);
    }
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
    for (const long number : numbers) {
      if (const auto cell = cell_of_.find(number); cell != cell_of_.end()) {
        made_.cell_sets[name].push_back(cell->second);
        const std::vector<long>& of_cell = from_.cells[static_cast<std::size_t>(cell->second)].nodes;
        nodes.insert(nodes.end(), of_cell.begin(), of_cell.end());
      } else if (const auto other = from_.others.find(number); other != from_.others.end()) {
        nodes.insert(nodes.end(), other->second.begin(), other->second.end());
      }
    }
    made_.node_sets.try_emplace(name, known(nodes));
  }

  const ForeignMesh& from_;
  double length_;
  Axis axis_;
  CellMesh made_;
  std::vector<Eigen::Vector3d> places_;
  std::map<long, int> node_of_, cell_of_;
};

}  // namespace

std::string CellMesh::place_of(int node) const {
  std::ostringstream text;
  text << "x y z = " << nodes.col(node).transpose() << " m";
  return text.str();
}

CellMesh in_our_terms(const ForeignMesh& mesh, double length, Axis axis) {
  return Translation(mesh, length, axis).run();
}

}  // namespace tiprub
