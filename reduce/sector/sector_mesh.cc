// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/sector/sector_mesh.h"

#include <algorithm>
#include <sstream>

namespace tiprub {

std::string place_text(const Eigen::Vector3d& position) {
  std::ostringstream text;
  text << "x y z = " << position.x() << " " << position.y() << " " << position.z() << " m";
  return text.str();
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
