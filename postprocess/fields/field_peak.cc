// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_peak.h"

#include <algorithm>
#include <cmath>

namespace tiprub {

namespace {

/// The part that most of a node's cells belong to.
std::string part_of(const SectorFields& sector, int node) {
  std::string best;
  std::size_t most = 0;
  for (const auto& [name, cells] : sector.parts) {
    std::size_t count = 0;
    for (const int cell : cells) count += (sector.cells.col(cell).array() == node).any() ? 1 : 0;
    if (count > most) best = name;
    most = std::max(most, count);
  }
  return best;
}

}  // namespace

FieldPeak field_peak(const SectorFields& sector, double speed, const WheelField& vibration, const WheelField& spin) {
  FieldPeak peak;
  peak.speed = speed;
  peak.displacement = largest_displacement(vibration);
  Eigen::Index worst_node = 0;
  for (std::size_t j = 0; j < vibration.displacement.size(); ++j) {
    Eigen::Index node = 0;
    const double here = von_mises(vibration.stress[j]).maxCoeff(&node);
    if (here > peak.vibration) {
      peak.vibration = here;
      peak.sector = static_cast<int>(j);
      worst_node = node;
    }
    peak.spin = std::max(peak.spin, von_mises(spin.stress[j]).maxCoeff());
    peak.both = std::max(peak.both, von_mises(vibration.stress[j] + spin.stress[j]).maxCoeff());
  }
  peak.place << sector.nodes.col(worst_node).head<2>().norm(),
      std::atan2(sector.nodes(1, worst_node), sector.nodes(0, worst_node)), sector.nodes(2, worst_node);
  peak.part = part_of(sector, static_cast<int>(worst_node));
  return peak;
}

}  // namespace tiprub
