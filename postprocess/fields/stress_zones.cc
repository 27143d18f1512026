// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/stress_zones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "cases/program/errors.h"
#include "postprocess/fields/blade_place.h"
#include "postprocess/fields/wheel_surface.h"

namespace tiprub {

namespace {

constexpr double default_patch = 0.05;  // of the tip line's length

/// Through the contact nodes, one a column; a single one is a line of no length.
double distance_to_line(const Eigen::Vector3d& place, const Eigen::Matrix3Xd& line) {
  double nearest = (place - line.col(0)).norm();
  for (Eigen::Index k = 0; k + 1 < line.cols(); ++k) {
    const Eigen::Vector3d along = line.col(k + 1) - line.col(k), from = place - line.col(k);
    const double share = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (from - share * along).norm());
  }
  return nearest;
}

/// Clamped nodes on a face that is seen and not wholly clamped.
std::set<int> clamp_edge(const SectorFields& sector) {
  const std::vector<int>& clamped = sector.node_set("clamped");
  const std::set<int> held(clamped.begin(), clamped.end());
  std::set<int> edge;
  for (const SurfaceFace& face : sector_surface(sector)) {
    if (face.side != SurfaceFace::Side::free) continue;
    const auto is_held = [&](int node) { return held.contains(node); };
    if (std::all_of(face.nodes.begin(), face.nodes.end(), is_held)) continue;
    std::copy_if(face.nodes.begin(), face.nodes.end(), std::inserter(edge, edge.end()), is_held);
  }
  return edge;
}

}  // namespace

double tip_length(const SectorFields& sector) {
  const std::vector<int>& line = tip_line(sector);
  double length = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    length += (sector.nodes.col(line[k + 1]) - sector.nodes.col(line[k])).norm();
  return length;
}

StressZones stress_zones(const SectorFields& sector, double tip_patch) {
  const double length = tip_patch > 0 ? tip_patch : default_patch * tip_length(sector);
  StressZones zones{length, length, {}};
  const Eigen::Matrix3Xd line = sector.nodes(Eigen::all, sector.node_set("contact"));
  const std::set<int> edge = clamp_edge(sector);
  for (Eigen::Index node = 0; node < sector.nodes.cols(); ++node) {
    const Eigen::Vector3d place = sector.nodes.col(node);
    const auto near = [&](int other) {
      return (meridional(place) - meridional(sector.nodes.col(other))).norm() <= length;
    };
    StressZone& zone = zones.at_node.emplace_back(StressZone::body);
    if (std::any_of(edge.begin(), edge.end(), near)) zone = StressZone::clamp_rim;
    if (distance_to_line(place, line) <= length) zone = StressZone::tip_patch;
  }
  if (std::find(zones.at_node.begin(), zones.at_node.end(), StressZone::body) == zones.at_node.end())
    throw InputError("no node is farther than " + std::to_string(length) +
                     " m from the tip line or the clamp's edge; lower [postprocess] tip_patch_mm");
  return zones;
}

}  // namespace tiprub
