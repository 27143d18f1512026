// SPDX-License-Identifier: GPL-3.0-or-later
// gmsh's own format: cells of all volumes, each once, and the named physical groups.
#include <map>
#include <set>

#include "cases/program/errors.h"
#include "mesh/cells/cell_kind.h"
#include "mesh/cells/gmsh_file.h"
#include "mesh/import/foreign_mesh.h"

namespace tiprub::mesh {

namespace {

/// gmsh's types with nodes in the middle of faces and of the cell, and the types that these are without them: the
/// further nodes come last.
const std::map<int, int> incomplete = {{12, 17}, {13, 18}, {14, 19}};

std::string said_of(const GmshElements& elements) {
  return elements.group.empty() ? "cells in no physical group" : "volume group \"" + elements.group + "\"";
}

const CellKind& kind_of(const GmshElements& elements, const std::string& file) {
  const auto without_centres = incomplete.find(elements.type);
  const int type = without_centres == incomplete.end() ? elements.type : without_centres->second;
  for (const CellKind& kind : all_cell_kinds())
    if (kind.gmsh_type == type) return kind;
  const std::map<int, std::string> linear = {{4, "tetrahedra"}, {5, "bricks"}, {6, "wedges"}, {7, "pyramids"}};
  const auto known = linear.find(elements.type);
  throw InputError(file + ": " + said_of(elements) + ": " +
                   (known == linear.end() ? "elements of gmsh type " + std::to_string(elements.type) +
                                                " are not quadratic ones; mesh again"
                                          : known->second + " that have corners only bend too stiffly; mesh again") +
                   " with Mesh.ElementOrder = 2, or gmsh -order 2");
}

class MshReader {
 public:
  explicit MshReader(const NamedText& file) : from_(read_gmsh_file(file)) { mesh_.file = file.name; }

  ForeignMesh read() {
    for (std::size_t i = 0; i < from_.node_tags.size(); ++i)
      mesh_.nodes.emplace(static_cast<long>(from_.node_tags[i]),
                          Eigen::Map<const Eigen::Vector3d>(from_.positions.data() + 3 * i));
    for (const GmshElements& elements : from_.elements)
      if (elements.dimension == 3) add_cells(elements);
    if (mesh_.cells.empty())
      throw InputError(mesh_.file +
                       ": holds no cells; mesh in three dimensions (gmsh -3), and name the volume too, by Physical "
                       "Volume(\"sector\"): gmsh saves only what is in a physical group once there is one");
    for (const int dimension : {2, 1, 0}) add_groups(dimension);
    return std::move(mesh_);
  }

 private:
  /// Format 2.2 repeats a cell for each of its groups, so that cells of the same nodes are one.
  void add_cells(const GmshElements& elements) {
    const CellKind& kind = kind_of(elements, mesh_.file);
    const std::size_t width = elements.nodes_per_element();
    for (std::size_t i = 0; i < elements.tags.size(); ++i) {
      ForeignCell cell{static_cast<long>(elements.tags[i]), {}};
      for (const int at : kind.gmsh_node)
        cell.nodes.push_back(static_cast<long>(elements.nodes[i * width + static_cast<std::size_t>(at)]));
      const auto [known, is_new] = number_of_.emplace(std::set(cell.nodes.begin(), cell.nodes.end()), cell.number);
      if (!elements.group.empty()) mesh_.cell_sets[elements.group].push_back(known->second);
      if (is_new) mesh_.cells.push_back(std::move(cell));
    }
  }

  /// A name may stand for groups of several dimensions. As a set of nodes it is the surface, or else the curve.
  void add_groups(int dimension) {
    std::map<std::string, std::vector<long>> found;
    for (const GmshElements& elements : from_.elements)
      if (elements.dimension == dimension)
        for (const std::size_t node : elements.nodes) found[elements.group].push_back(static_cast<long>(node));
    mesh_.node_sets.merge(found);
  }

  GmshFile from_;
  ForeignMesh mesh_;
  std::map<std::set<long>, long> number_of_;  // of cells, by their nodes
};

}  // namespace

ForeignMesh read_msh(const NamedText& file) {
  return MshReader(file).read();
}

}  // namespace tiprub::mesh
