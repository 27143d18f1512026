// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_file.h"

#include <gmsh.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "cases/program/errors.h"

namespace tiprub::mesh {

namespace {

// gmsh's numbers for the kinds of elements.
constexpr int line2 = 1, quad8 = 16, quad9 = 10;
constexpr int volume_dimension = 3, surface_dimension = 2, curve_dimension = 1;

// gmsh has one model for the whole program. A session lasts while a file is written.
class GmshSession {
 public:
  GmshSession() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
    gmsh::option::setNumber("Mesh.Binary", 0);
    gmsh::model::add("sector");
  }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
  ~GmshSession() { gmsh::finalize(); }
};

void add_nodes(const NamedMesh& mesh, int entity) {
  std::vector<std::size_t> tags(mesh.nodes.size());
  std::iota(tags.begin(), tags.end(), std::size_t{1});
  std::vector<double> coordinates;
  coordinates.reserve(3 * mesh.nodes.size());
  for (const Eigen::Vector3d& x : mesh.nodes) coordinates.insert(coordinates.end(), x.data(), x.data() + 3);
  gmsh::model::mesh::addNodes(volume_dimension, entity, tags, coordinates);
}

/// The nodes of elements of one of gmsh's types, in gmsh's order, counted from 1. For faces and lines that is VTK's
/// order.
std::vector<std::size_t> for_gmsh(int type, const std::vector<std::size_t>& nodes) {
  std::vector<int> place = {0};
  for (const CellKind& kind : all_cell_kinds())
    if (kind.gmsh_type == type) place = kind.gmsh_node;
  std::vector<std::size_t> turned(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const std::size_t in_cell = k % place.size();
    turned[k - in_cell + static_cast<std::size_t>(place[in_cell])] = nodes[k] + 1;
  }
  return turned;
}

/// gmsh wants all volumes first, then the nodes, then the elements.
void add_entities(const NamedMesh& mesh) {
  std::vector<int> tags;
  for (const NamedMesh::Entity& entity : mesh.entities)
    tags.push_back(gmsh::model::addDiscreteEntity(entity.dimension));
  add_nodes(mesh, tags.front());
  std::vector<std::pair<std::string, std::vector<int>>> groups;  // in the order of their first entities
  std::map<std::string, int> dimension;
  for (std::size_t e = 0; e < mesh.entities.size(); ++e) {
    for (const auto& [type, nodes] : mesh.entities[e].elements)
      gmsh::model::mesh::addElementsByType(tags[e], type, {}, for_gmsh(type, nodes));
    for (const std::string& name : mesh.entities[e].groups) {
      dimension[name] = mesh.entities[e].dimension;
      auto known = std::ranges::find_if(groups, [&](const auto& group) { return group.first == name; });
      if (known == groups.end()) known = groups.insert(groups.end(), {name, {}});
      known->second.push_back(tags[e]);
    }
  }
  for (const auto& [name, entities] : groups)
    gmsh::model::setPhysicalName(dimension[name], gmsh::model::addPhysicalGroup(dimension[name], entities), name);
}

// gmsh doesn't report a full disk, so the end of the file is compared with that of a whole one.
void require_whole(const std::filesystem::path& path) {
  const std::string last_words = "$EndElements\n";
  std::ifstream file(path, std::ios::binary);
  file.seekg(-static_cast<std::streamoff>(last_words.size()), std::ios::end);
  const std::string end(std::istreambuf_iterator<char>(file), {});
  if (end != last_words) throw RunError(path.string() + ": can't be written whole; is the disk full?");
}

NamedMesh::Entity part_of(const MeshedSector& mesh, Region region, const char* name) {
  NamedMesh::Entity part{volume_dimension, {"sector", name}, {}};
  for (const SectorCell& cell : mesh.cells)
    if (cell.region == region) {
      std::vector<std::size_t>& nodes = part.elements[mesh.kind().gmsh_type];
      nodes.insert(nodes.end(), cell.nodes.begin(), cell.nodes.end());
    }
  return part;
}

}  // namespace

std::vector<std::size_t> pieces_of(const std::vector<std::size_t>& line) {
  std::vector<std::size_t> ends;
  for (std::size_t n = 0; n + 1 < line.size(); ++n) ends.insert(ends.end(), {line[n], line[n + 1]});
  return ends;
}

void write_mesh(const NamedMesh& mesh, const std::filesystem::path& path) {
  try {
    const GmshSession session;
    add_entities(mesh);
    gmsh::write(path.string());
  } catch (const std::string& message) {  // what gmsh 4.8 throws
    throw RunError(path.string() + ": can't be written: gmsh says: " + message);
  }
  require_whole(path);
}

NamedMesh named_groups(const MeshedSector& mesh) {
  NamedMesh named{mesh.nodes, {}};
  for (const auto& [region, name] :
       {std::pair{Region::disc, "disc"}, {Region::main_blade, "main_blade"}, {Region::splitter, "splitter"}})
    if (NamedMesh::Entity part = part_of(mesh, region, name); !part.elements.empty()) named.entities.push_back(part);
  const int face = mesh.element == ElementKind::hex20 ? quad8 : quad9;
  for (const SectorSurface& surface : mesh.surfaces)
    named.entities.push_back({surface_dimension, {surface.name}, {{face, surface.face_nodes}}});
  for (const auto& [name, line] : {std::pair{"contact", &mesh.contact}, {"contact_splitter", &mesh.contact_splitter}})
    if (!line->empty()) named.entities.push_back({curve_dimension, {name}, {{line2, pieces_of(*line)}}});
  return named;
}

}  // namespace tiprub::mesh
