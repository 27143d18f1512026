// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/wave_maps.h"

#include <cmath>

#include "simulate/response/peaks.h"

namespace tiprub {

std::vector<Ridge> find_ridges(const InteractionMap& map, const FrequencyCurves& curves, int sector_count,
                               const PostprocessParameters& parameters) {
  const double floor = map.largest() * std::pow(10.0, -parameters.amplitude_decades);
  std::vector<Ridge> ridges;
  for (int order = 1; order <= parameters.engine_order_max; ++order)
    for (int column = 0; column < sector_count; ++column) {
      const int n = signed_nodal_diameter(column, sector_count);
      const Eigen::VectorXd curve = map.wave(order, n);
      for (const Peak& peak : find_peaks(curve, parameters.prominence)) {
        if (curve[peak.index] < floor) continue;
        const double speed = map.columns[static_cast<std::size_t>(peak.index)].speed;
        ridges.push_back({speed, label_wave(curves, sector_count, speed, order, n, curve[peak.index])});
      }
    }
  return ridges;
}

WaveMaps wave_maps(const Response& response, const ContactLine& contact, const FrequencyCurves& curves,
                   const PostprocessParameters& parameters) {
  const auto map_of = [&](int node) { return interaction_map(response, contact, node, parameters.component); };
  WaveMaps maps{parameters.edge, map_of(0), map_of(contact.trailing_edge()), {}};
  maps.ridges = find_ridges(maps.first(), curves, response.scene.sector_count, parameters);
  return maps;
}

}  // namespace tiprub
