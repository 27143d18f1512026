// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/wheel_surface.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "mesh/cells/cell_kind.h"

namespace tiprub::postprocess {

namespace {

SurfaceFace face_of(const Eigen::MatrixXi& cells, Eigen::Index cell, const CellKind& kind,
                    const std::vector<int>& around) {
  SurfaceFace face;
  for (const int corner : around) face.nodes.push_back(cells(corner, cell));
  for (std::size_t k = 0; k < around.size(); ++k)
    face.nodes.push_back(cells(kind.middle_of(around[k], around[(k + 1) % around.size()]), cell));
  return face;
}

bool all_in(const SurfaceFace& face, const std::vector<char>& set) {
  return std::all_of(face.nodes.begin(), face.nodes.end(), [&](int node) { return set[node] != 0; });
}

std::vector<char> marked(const SectorFields& sector, const char* name) {
  std::vector<char> set(static_cast<std::size_t>(sector.nodes.cols()), 0);
  for (const int node : sector.node_set(name)) set[node] = 1;
  return set;
}

}  // namespace

std::vector<SurfaceFace> sector_surface(const SectorFields& sector) {
  std::vector<int> cells(static_cast<std::size_t>(sector.cells.cols()));
  std::iota(cells.begin(), cells.end(), 0);
  return surface_of_cells(sector, cells);
}

std::vector<SurfaceFace> surface_of_cells(const SectorFields& sector, const std::vector<int>& cells) {
  std::map<std::vector<int>, std::pair<SurfaceFace, int>> faces;  // by their corners
  for (const int cell : cells) {
    const CellKind& kind = cell_kind(static_cast<int>(nodes_of(sector.cells, cell).size()));
    for (const std::vector<int>& around : kind.faces) {
      const SurfaceFace face = face_of(sector.cells, cell, kind, around);
      std::vector<int> key(face.nodes.begin(), face.nodes.begin() + face.corners());
      std::sort(key.begin(), key.end());
      ++faces.try_emplace(key, face, 0).first->second.second;
    }
  }
  const std::vector<char> low = marked(sector, "cyclic_low"), high = marked(sector, "cyclic_high");
  std::vector<SurfaceFace> surface;
  for (auto& [key, found] : faces) {
    auto& [face, times] = found;
    if (times > 1) continue;
    if (all_in(face, low)) face.side = SurfaceFace::Side::cyclic_low;
    if (all_in(face, high)) face.side = SurfaceFace::Side::cyclic_high;
    surface.push_back(face);
  }
  return surface;
}

}  // namespace tiprub::postprocess
