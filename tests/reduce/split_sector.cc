// SPDX-License-Identifier: GPL-3.0-or-later
// A sector of 27-node bricks as one of other cells, in msh 2.2.
//
// usage: split_sector SECTOR.msh tet10|wedge15|pyramid13|hex20|mixed OTHER.msh
#include "tests/reduce/split_cells.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/cells/cell_kind.h"
#include "reduce/sector/sector_reader.h"

namespace {

using namespace tiprub;
using namespace tiprub::reduce;

struct Element {
  int type, group;
  std::vector<int> nodes;
};

const std::map<std::string, test::Split> kinds = {{"tet10", test::Split::tet10},
                                                  {"wedge15", test::Split::wedge15},
                                                  {"pyramid13", test::Split::pyramid13},
                                                  {"hex20", test::Split::hex20},
                                                  {"mixed", test::Split::mixed}};

/// Faces of cells whose nodes are all in a set.
void add_faces(const SectorMesh& mesh, const std::vector<int>& set, int group, std::vector<Element>& elements) {
  const std::set<int> members(set.begin(), set.end());
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto listed = nodes_of(mesh.cells, cell);
    const CellKind& kind = cell_kind(static_cast<int>(listed.size()));
    for (const std::vector<int>& around : kind.faces) {
      Element face{around.size() == 3 ? 9 : 16, group, {}};
      for (const int corner : around) face.nodes.push_back(listed[corner]);
      for (std::size_t k = 0; k < around.size(); ++k)
        face.nodes.push_back(listed[kind.middle_of(around[k], around[(k + 1) % around.size()])]);
      if (std::all_of(face.nodes.begin(), face.nodes.end(), [&](int node) { return members.contains(node); }))
        elements.push_back(face);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const SectorMesh bricks = read_sector_mesh(argv[1], 1e-6);
  if (bricks.cells.rows() != 27) {
    std::cerr << argv[1] << ": must be of 27-node bricks; mesh it with mesh.element=\"hex27\"\n";
    return 2;
  }
  const SectorMesh mesh = test::split(bricks, kinds.at(argv[2]));
  std::vector<Element> elements;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto nodes = nodes_of(mesh.cells, cell);
    const CellKind& kind = cell_kind(static_cast<int>(nodes.size()));
    Element element{kind.gmsh_type, 1, std::vector<int>(kind.gmsh_node.size())};
    for (int k = 0; k < kind.nodes(); ++k) element.nodes[kind.gmsh_node[k]] = nodes[k];
    elements.push_back(element);
  }
  add_faces(mesh, mesh.cyclic_low, 2, elements);
  add_faces(mesh, mesh.cyclic_high, 3, elements);
  add_faces(mesh, mesh.clamped, 4, elements);
  for (std::size_t k = 1; k < mesh.contact_line.size(); ++k)
    elements.push_back({1, 5, {mesh.contact_line[k - 1], mesh.contact_line[k]}});
  std::ofstream out(argv[3]);
  out << std::setprecision(17) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n3 1 \"sector\"\n2 2 "
      << "\"cyclic_low\"\n2 3 \"cyclic_high\"\n2 4 \"clamped\"\n1 5 \"contact\"\n$EndPhysicalNames\n$Nodes\n"
      << mesh.node_count() << "\n";
  for (int node = 0; node < mesh.node_count(); ++node)
    out << node + 1 << " " << mesh.nodes.col(node).transpose() << "\n";
  out << "$EndNodes\n$Elements\n" << elements.size() << "\n";
  for (std::size_t e = 0; e < elements.size(); ++e) {
    out << e + 1 << " " << elements[e].type << " 2 " << elements[e].group << " " << elements[e].group;
    for (const int node : elements[e].nodes) out << " " << node + 1;
    out << "\n";
  }
  out << "$EndElements\n";
  return out.flush() ? 0 : 1;
}
