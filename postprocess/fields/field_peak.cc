// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_peak.h"

#include <algorithm>
#include <cmath>

namespace tiprub {

namespace {

/// The first node of a zone with the largest value; -1 if the zone is empty.
Eigen::Index largest_in(StressZone zone, const StressZones& zones, const Eigen::VectorXd& values) {
  Eigen::Index largest = -1;
  for (Eigen::Index node = 0; node < values.size(); ++node)
    if (zones.at_node[static_cast<std::size_t>(node)] == zone && (largest < 0 || values[node] > values[largest]))
      largest = node;
  return largest;
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
    if (strength)
      for (Eigen::Index node = 0; node < severity.size(); ++node)
        severity[node] = goodman_utilisation(*strength, severity[node], stress.mean(node, h));
    const Eigen::Index node = largest_in(StressZone::body, zones, severity);
    if (severity[node] <= most) continue;
    most = severity[node];
    worst = {stress.mean(node, h), stress.alternating(node, h), places.words(static_cast<int>(node)), std::nullopt};
  }
  if (strength) worst.goodman = most;
  return worst;
}

}  // namespace

FieldPeak field_peak(const SectorFields& sector, const CycleStress& stress, const StressZones& zones,
                     const BladePlaces& places, const std::optional<MaterialStrength>& strength) {
  FieldPeak peak;
  peak.displacement = stress.displacement;
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

}  // namespace tiprub
