// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sector/sector_file.h"

#include <gmsh.h>

#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

// gmsh's numbers for the kinds of elements.
constexpr int line2 = 1, quad8 = 16, quad9 = 10, hex20 = 17, hex27 = 12;
constexpr int volume_dimension = 3, surface_dimension = 2, curve_dimension = 1;

// gmsh is one model for the whole program; this one lives as long as a file is written.
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

std::vector<std::size_t> gmsh_tags(const std::size_t* begin, const std::size_t* end) {
  std::vector<std::size_t> tags(begin, end);
  for (std::size_t& tag : tags) ++tag;  // gmsh counts from 1
  return tags;
}

void add_named_group(int dimension, const std::vector<int>& entities, const std::string& name) {
  const int group = gmsh::model::addPhysicalGroup(dimension, entities);
  gmsh::model::setPhysicalName(dimension, group, name);
}

void add_nodes(const MeshedSector& mesh, int entity) {
  std::vector<std::size_t> tags(mesh.nodes.size());
  std::iota(tags.begin(), tags.end(), std::size_t{1});
  std::vector<double> coordinates;
  coordinates.reserve(3 * mesh.nodes.size());
  for (const Eigen::Vector3d& x : mesh.nodes) coordinates.insert(coordinates.end(), x.data(), x.data() + 3);
  gmsh::model::mesh::addNodes(volume_dimension, entity, tags, coordinates);
}

std::vector<std::size_t> nodes_of(const MeshedSector& mesh, Region region) {
  std::vector<std::size_t> nodes;
  for (const SectorCell& cell : mesh.cells) {
    if (cell.region != region) continue;
    const auto tags = gmsh_tags(cell.nodes.data(), cell.nodes.data() + node_count(mesh.element));
    nodes.insert(nodes.end(), tags.begin(), tags.end());
  }
  return nodes;
}

void add_volumes(const MeshedSector& mesh) {
  struct Volume {
    Region region;
    const char* name;
    int entity;
  };
  std::vector<Volume> volumes = {
      {Region::disc, "disc", 0}, {Region::main_blade, "main_blade", 0}, {Region::splitter, "splitter", 0}};
  std::erase_if(volumes, [&](const Volume& volume) { return nodes_of(mesh, volume.region).empty(); });
  for (Volume& volume : volumes) volume.entity = gmsh::model::addDiscreteEntity(volume_dimension);
  add_nodes(mesh, volumes.front().entity);
  std::vector<int> all;
  for (const Volume& volume : volumes) {
    gmsh::model::mesh::addElementsByType(volume.entity, mesh.element == ElementKind::hex20 ? hex20 : hex27, {},
                                         nodes_of(mesh, volume.region));
    all.push_back(volume.entity);
  }
  add_named_group(volume_dimension, all, "sector");
  for (const Volume& volume : volumes) add_named_group(volume_dimension, {volume.entity}, volume.name);
}

void add_surface(const MeshedSector& mesh, const SectorSurface& surface) {
  const int entity = gmsh::model::addDiscreteEntity(surface_dimension);
  const std::size_t* first = surface.face_nodes.data();
  gmsh::model::mesh::addElementsByType(entity, mesh.element == ElementKind::hex20 ? quad8 : quad9, {},
                                       gmsh_tags(first, first + surface.face_nodes.size()));
  add_named_group(surface_dimension, {entity}, surface.name);
}

void add_contact_curve(const MeshedSector& mesh) {
  const int entity = gmsh::model::addDiscreteEntity(curve_dimension);
  std::vector<std::size_t> ends;
  for (std::size_t n = 0; n + 1 < mesh.contact.size(); ++n)
    ends.insert(ends.end(), {mesh.contact[n] + 1, mesh.contact[n + 1] + 1});
  gmsh::model::mesh::addElementsByType(entity, line2, {}, ends);
  add_named_group(curve_dimension, {entity}, "contact");
}

// gmsh says nothing of a disk that is full; the last words of a whole file do.
void require_whole(const std::filesystem::path& path) {
  const std::string last_words = "$EndElements\n";
  std::ifstream file(path, std::ios::binary);
  file.seekg(-static_cast<std::streamoff>(last_words.size()), std::ios::end);
  const std::string end(std::istreambuf_iterator<char>(file), {});
  if (end != last_words) throw RunError(path.string() + ": can't be written whole; is the disk full?");
}

}  // namespace

void write_sector(const MeshedSector& mesh, const std::filesystem::path& path) {
  try {
    const GmshSession session;
    add_volumes(mesh);
    for (const SectorSurface& surface : mesh.surfaces) add_surface(mesh, surface);
    add_contact_curve(mesh);
    gmsh::write(path.string());
  } catch (const std::string& message) {  // what gmsh 4.8 throws
    throw RunError(path.string() + ": can't be written: gmsh says: " + message);
  }
  require_whole(path);
}

}  // namespace tiprub
