// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/effects/casing_wear.h"

#include <algorithm>
#include <numbers>

namespace tiprub {

namespace {

/// [m] a node's share of its blade's tip line.
double width_of(const ContactLine& contact, int node) {
  const bool on_splitter = node > contact.trailing_edge();
  const int first = on_splitter ? contact.trailing_edge() + 1 : 0;
  const int last = on_splitter ? contact.size() - 1 : contact.trailing_edge();
  const int before = std::max(node - 1, first), after = std::min(node + 1, last);
  return 0.5 * (contact.arc_length[after] - contact.arc_length[before]);
}

/// [1] of the casing's areas that any blade touches at a contact node. Sector j's counts are those of sector j mod
/// N_s, turned with it.
double rubbed_share(const SpeedResponse& response, const SimulatedScene& scene, int nodes, int node) {
  const Eigen::Index areas = response.contact_count.cols();
  Eigen::ArrayX<bool> rubbed = Eigen::ArrayX<bool>::Constant(areas, false);
  for (Eigen::Index j = 0; j < scene.sector_count; ++j) {
    const Eigen::Index held = j % scene.independent_sectors, turn = areas * (j - held) / scene.sector_count;
    for (Eigen::Index area = 0; area < areas; ++area)
      if (response.contact_count(held * nodes + node, area) > 0) rubbed[(area + turn) % areas] = true;
  }
  return static_cast<double>(rubbed.count()) / static_cast<double>(areas);
}

}  // namespace

CasingWear casing_wear(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                       double coefficient, double time) {
  CasingWear worst;
  const int nodes = contact.size(), held = scene.independent_sectors;
  for (int node = 0; node < nodes; ++node) {
    double force = 0;
    for (int sector = 0; sector < held; ++sector)
      force += response.contact_force.col(sector * nodes + node).mean() / held;
    const double track = width_of(contact, node) * rubbed_share(response, scene, nodes, node);
    if (!(force > 0 && track > 0)) continue;
    const double depth =
        coefficient * scene.sector_count * force * response.speed * time / (2 * std::numbers::pi * track);
    if (depth > worst.depth) worst = {node, force, depth};
  }
  return worst;
}

}  // namespace tiprub
