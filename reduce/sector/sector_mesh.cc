// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/sector_mesh.h"

#include <algorithm>
#include <sstream>

#include "cases/program/digest.h"

namespace tiprub {

std::string place_text(const Eigen::Vector3d& position) {
  std::ostringstream text;
  text << "x y z = " << position.x() << " " << position.y() << " " << position.z() << " m";
  return text.str();
}

std::string digest(const SectorMesh& mesh) {
  Digest digest;
  digest.add(mesh.sector_count);
  digest.add(mesh.nodes_per_cell());
  digest.add(mesh.nodes.data(), static_cast<std::size_t>(mesh.nodes.size()));
  digest.add(mesh.cells.data(), static_cast<std::size_t>(mesh.cells.size()));
  const auto add = [&](const std::vector<int>& members) {
    digest.add(members.size());
    digest.add(members.data(), members.size());
  };
  for (const auto* group : {&mesh.cyclic_low, &mesh.cyclic_high, &mesh.clamped, &mesh.contact_line}) add(*group);
  digest.add(mesh.tip_faces.data(), static_cast<std::size_t>(mesh.tip_faces.size()));
  for (const auto& [name, cells] : mesh.parts) {
    digest.add(name);
    add(cells);
  }
  return digest.digits();
}

std::string SectorMesh::place_of(int node) const {
  return place_text(nodes.col(node));
}

std::string SectorMesh::name_of_cell(int cell) const {
  std::string name = "cell " + std::to_string(cell_tags.empty() ? static_cast<std::size_t>(cell) : cell_tags[cell]);
  for (const auto& [part, members] : parts)
    if (std::find(members.begin(), members.end(), cell) != members.end()) name += " (" + part + ")";
  return name;
}

}  // namespace tiprub
