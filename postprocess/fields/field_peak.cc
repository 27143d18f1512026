// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_peak.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "cases/program/errors.h"

namespace tiprub::postprocess {

namespace {

constexpr double default_patch = 0.05;  // of the tip line's length

/// [m] To the line through some places, the columns of `line`; there may be only one.
double distance_to_line(const Eigen::Vector3d& place, const Eigen::Matrix3Xd& line) {
  double nearest = (place - line.col(0)).norm();
  for (Eigen::Index k = 0; k + 1 < line.cols(); ++k) {
    const Eigen::Vector3d along = line.col(k + 1) - line.col(k), from = place - line.col(k);
    const double share = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (from - share * along).norm());
  }
  return nearest;
}

/// Clamped nodes on faces of the free surface that are only partly clamped.
std::set<int> clamp_edge(const SectorFields& sector) {
  const std::vector<int>& clamped = sector.node_set("clamped");
  const std::set<int> held(clamped.begin(), clamped.end());
  std::set<int> edge;
  for (const SurfaceFace& face : sector_surface(sector)) {
    if (face.side != SurfaceFace::Side::free) continue;
    const auto is_held = [&](int node) { return held.contains(node); };
    if (std::ranges::all_of(face.nodes, is_held)) continue;
    std::copy_if(face.nodes.begin(), face.nodes.end(), std::inserter(edge, edge.end()), is_held);
  }
  return edge;
}

StressMaxima maxima_of(StressZone zone, const StressZones& zones, const CycleStress& stress) {
  const auto largest = [&](const Eigen::VectorXd& values) {
    const Eigen::Index node = largest_in(zone, zones, values);
    return node < 0 ? 0.0 : values[node];
  };
  return {largest(stress.vibration), largest(stress.spin), largest(stress.both)};
}

StressCycle worst_cycle(const CycleStress& stress, const StressZones& zones, const BladePlaces& places,
                        const std::optional<MaterialStrength>& strength) {
  StressCycle worst;
  double most = -1;
  for (Eigen::Index h = 0; h < stress.mean.cols(); ++h) {
    Eigen::VectorXd severity = stress.alternating.col(h);
    if (strength) severity = goodman_utilisation<Eigen::VectorXd>(*strength, severity, stress.mean.col(h));
    const Eigen::Index node = largest_in(StressZone::body, zones, severity);
    if (severity[node] <= most) continue;
    most = severity[node];
    worst = {stress.mean(node, h), stress.alternating(node, h), places.words(static_cast<int>(node)), std::nullopt,
             strength};
  }
  if (strength) worst.goodman = most;
  return worst;
}

}  // namespace

double tip_length(const SectorFields& sector) {
  const std::vector<int>& line = tip_line(sector);
  double length = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    length += (sector.nodes.col(line[k + 1]) - sector.nodes.col(line[k])).norm();
  return length;
}

StressZones stress_zones(const SectorFields& sector, double width) {
  const double length = width > 0 ? width : default_patch * tip_length(sector);
  StressZones zones{length, {}};
  std::vector<Eigen::Matrix3Xd> lines = {sector.nodes(Eigen::all, tip_line(sector))};
  if (const auto splitter = sector.node_sets.find("contact_splitter"); splitter != sector.node_sets.end())
    lines.emplace_back(sector.nodes(Eigen::all, splitter->second));
  const std::set<int> edge = clamp_edge(sector);
  for (Eigen::Index node = 0; node < sector.nodes.cols(); ++node) {
    const Eigen::Vector3d place = sector.nodes.col(node);
    const auto near = [&](int other) {
      return (meridional(place) - meridional(sector.nodes.col(other))).norm() <= length;
    };
    StressZone& zone = zones.at_node.emplace_back(StressZone::body);
    if (std::ranges::any_of(edge, near)) zone = StressZone::clamp_rim;
    const auto reaches = [&](const Eigen::Matrix3Xd& line) { return distance_to_line(place, line) <= length; };
    if (std::ranges::any_of(lines, reaches)) zone = StressZone::tip_patch;
  }
  if (std::ranges::find(zones.at_node, StressZone::body) == zones.at_node.end())
    throw InputError("no node is farther than " + std::to_string(length) +
                     " m from the tip line or the clamp's edge; lower [postprocess] tip_patch_mm");
  return zones;
}

Eigen::Index largest_in(StressZone zone, const StressZones& zones, const Eigen::VectorXd& values) {
  Eigen::Index largest = -1;
  for (Eigen::Index node = 0; node < values.size(); ++node)
    if (zones.at_node[static_cast<std::size_t>(node)] == zone && (largest < 0 || values[node] > values[largest]))
      largest = node;
  return largest;
}

double allowed_alternating(const StressCycle& cycle) {
  return cycle.strength->endurance * std::max(0.0, 1 - cycle.mean / cycle.strength->ultimate);
}

FieldPeak field_peak(const SectorFields& sector, const CycleStress& stress, const StressZones& zones,
                     const BladePlaces& places, const std::optional<MaterialStrength>& strength) {
  FieldPeak peak;
  peak.displacement = stress.displacement.maxCoeff();
  peak.body = maxima_of(StressZone::body, zones, stress);
  peak.tip_patch = maxima_of(StressZone::tip_patch, zones, stress);
  peak.clamp_rim = maxima_of(StressZone::clamp_rim, zones, stress);
  const Eigen::Index worst = largest_in(StressZone::body, zones, stress.vibration);
  peak.sector = stress.sector[worst];
  peak.sample = stress.sample[worst];
  const Eigen::Vector3d place = sector.nodes.col(worst);
  peak.place << std::hypot(place[0], place[1]), std::atan2(place[1], place[0]), place[2];
  peak.part = places.part(static_cast<int>(worst));
  peak.where = places.words(static_cast<int>(worst));
  if (stress.mean.cols() > 0) peak.cycle = worst_cycle(stress, zones, places, strength);
  if (strength && strength->yield) peak.yield_share = peak.body.both / *strength->yield;
  return peak;
}

}  // namespace tiprub::postprocess
