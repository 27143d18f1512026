// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/wheel_surface.h"

#include <algorithm>
#include <map>

namespace tiprub {

namespace {

// Corners of the faces of VTK's bricks, around; the node in the middle of each edge.
constexpr std::array<std::array<int, 4>, 6> face_corners = {
    {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
constexpr std::array<std::array<int, 2>, 12> edge_corners = {
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
constexpr int corners = 8;

int middle_of(int a, int b) {
  for (std::size_t e = 0; e < edge_corners.size(); ++e)
    if ((edge_corners[e][0] == a && edge_corners[e][1] == b) || (edge_corners[e][0] == b && edge_corners[e][1] == a))
      return corners + static_cast<int>(e);
  return -1;
}

SurfaceFace face_of(const Eigen::MatrixXi& cells, Eigen::Index cell, const std::array<int, 4>& around) {
  SurfaceFace face{};
  for (int k = 0; k < 4; ++k) {
    face.nodes[k] = cells(around[k], cell);
    face.nodes[4 + k] = cells(middle_of(around[k], around[(k + 1) % 4]), cell);
  }
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
  std::map<std::array<int, 4>, std::pair<SurfaceFace, int>> faces;
  for (Eigen::Index cell = 0; cell < sector.cells.cols(); ++cell)
    for (const std::array<int, 4>& around : face_corners) {
      const SurfaceFace face = face_of(sector.cells, cell, around);
      std::array<int, 4> key = {face.nodes[0], face.nodes[1], face.nodes[2], face.nodes[3]};
      std::sort(key.begin(), key.end());
      ++faces.try_emplace(key, face, 0).first->second.second;
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

FaceShape face_shape(double s, double t) {
  constexpr std::array<std::array<int, 2>, 8> place = {
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  FaceShape shape;
  for (int k = 0; k < 8; ++k) {
    const double a = place[k][0], b = place[k][1];
    const double f = a == 0 ? 1 - s * s : 1 + a * s, df = a == 0 ? -2 * s : a;
    const double g = b == 0 ? 1 - t * t : 1 + b * t, dg = b == 0 ? -2 * t : b;
    if (k >= 4) {
      shape.value[k] = 0.5 * f * g;
      shape.along_s[k] = 0.5 * df * g;
      shape.along_t[k] = 0.5 * f * dg;
    } else {
      const double slope = a * s + b * t - 1;
      shape.value[k] = 0.25 * f * g * slope;
      shape.along_s[k] = 0.25 * (df * g * slope + f * g * a);
      shape.along_t[k] = 0.25 * (f * dg * slope + f * g * b);
    }
  }
  return shape;
}

}  // namespace tiprub
