// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/wheel_surface.h"

#include <algorithm>
#include <utility>

namespace tiprub::postprocess {

namespace {

bool all_in(const SurfaceFace& face, const std::vector<char>& set) {
  return std::all_of(face.nodes.begin(), face.nodes.end(), [&](int node) { return set[node] != 0; });
}

std::vector<char> marked(const SectorFields& sector, const char* name) {
  std::vector<char> set(static_cast<std::size_t>(sector.nodes.cols()), 0);
  for (const int node : sector.node_set(name)) set[node] = 1;
  return set;
}

std::vector<SurfaceFace> surface_of(const SectorFields& sector, const std::vector<std::vector<int>>& cells) {
  const std::vector<char> low = marked(sector, "cyclic_low"), high = marked(sector, "cyclic_high");
  std::vector<SurfaceFace> surface;
  for (FreeFace& found : free_faces(sector.nodes, cells)) {
    SurfaceFace& face = surface.emplace_back(SurfaceFace{std::move(found), SurfaceFace::Side::free});
    if (all_in(face, low)) face.side = SurfaceFace::Side::cyclic_low;
    if (all_in(face, high)) face.side = SurfaceFace::Side::cyclic_high;
  }
  return surface;
}

}  // namespace

std::vector<SurfaceFace> sector_surface(const SectorFields& sector) {
  return surface_of(sector, listed_cells(sector.cells));
}

std::vector<SurfaceFace> surface_of_cells(const SectorFields& sector, const std::vector<int>& cells) {
  return surface_of(sector, listed_cells(sector.cells(Eigen::all, cells)));
}

}  // namespace tiprub::postprocess
