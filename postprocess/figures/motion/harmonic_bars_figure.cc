// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub {

namespace {

/// Engine order, nodal diameter, both directions of that wave [mm].
std::vector<Cell> bar_row(const TravellingSpectrum& spectrum, int engine_order, int nodal_diameter) {
  const double forward =
      is_standing(nodal_diameter, spectrum.sector_count) ? 0 : spectrum.at(engine_order, -nodal_diameter);
  return {engine_order, nodal_diameter, spectrum.at(engine_order, nodal_diameter) * mm_per_m, forward * mm_per_m};
}

}  // namespace

Figure harmonic_bars_figure(const Study& study) {
  const TravellingSpectrum& spectrum = study.map.columns[static_cast<std::size_t>(study.shown)].spectrum;
  const int half = spectrum.sector_count / 2, last = study.parameters.engine_order_max;
  // The casing's second harmonic and its nodal diameter: with two lobes on ten sectors the paper's EO 4 and nodal
  // diameter 4.
  const int order = 2 * std::max(study.response.scene.lobes, 1);
  const int diameter = aliased_nodal_diameter(order, spectrum.sector_count);
  Figure figure{.drawing = {.name = "harmonic_bars",
                            .width = 1000,
                            .height = 400,
                            .script = "harmonic_bars",
                            .values = {{"engine_order", order},
                                       {"nodal_diameter", diameter},
                                       {"nodal_diameters", half + 1},
                                       {"engine_orders", last}}},
                .title = "Harmonics at one speed",
                .caption = "At " + fixed(study.shown_response().speed * rpm_per_rad_s, 0) +
                           " rpm: the nodal diameters on engine order " + std::to_string(order) +
                           ", and the engine orders on nodal diameter " + std::to_string(diameter) +
                           ", both directions one on the other. The trackings follow these bars over speed.",
                .data = {{"engine order", "nodal diameter", "backward or standing [mm]", "forward [mm]"}, {}}};
  for (int n = 0; n <= half; ++n) figure.data.rows.push_back(bar_row(spectrum, order, n));
  for (int k = 1; k <= last; ++k) figure.data.rows.push_back(bar_row(spectrum, k, diameter));
  return figure;
}

}  // namespace tiprub
