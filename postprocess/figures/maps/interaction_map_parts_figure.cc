// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "postprocess/figures/maps/map_picture.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

bool moves(const Study& study, int nodal_diameter) {
  const std::vector<int>& moving = study.response.scene.nodal_diameters;
  return std::find(moving.begin(), moving.end(), nodal_diameter) != moving.end();
}

/// Those that move: a map of one at rest is empty.
std::vector<int> panel_nodal_diameters(const Study& study) {
  constexpr int most = 12;
  std::vector<int> panels;
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    if (moves(study, n)) panels.push_back(n);
  if (panels.size() > most) panels.resize(most);
  return panels;
}

Table ridge_table(const Study& study) {
  Table table{{"speed [rpm]", "engine order", "signed nodal diameter", "direction", "amplitude [mm]", "family",
               "natural frequency [Hz]", "detuning [%]"},
              {}};
  for (const Ridge& ridge : study.ridges)
    table.rows.push_back({ridge.speed * rpm_per_rad_s, ridge.wave.engine_order, ridge.wave.signed_nodal_diameter,
                          name_of(ridge.wave.direction), ridge.wave.amplitude * mm_per_m, ridge.wave.family + 1,
                          ridge.wave.natural_frequency, 100 * ridge.wave.detuning});
  return table;
}

}  // namespace

Figure interaction_map_parts_figure(const Study& study) {
  constexpr int width = 330, height = 260, columns = 3;
  const std::vector<int> panels = panel_nodal_diameters(study);
  const int count = static_cast<int>(panels.size()), rows = (count + columns - 1) / columns;
  Figure figure{
      .drawing = {.name = "interaction_map_parts",
                  .width = 1100,
                  .height = 100 + 330 * rows,
                  .script = "interaction_map_parts"},
      .title = "Interaction map by nodal diameter",
      .caption =
          std::string("The parts whose sum is the interaction map of the ") + name_of(study.parameters.edge) +
          ", on the same colours; forward and backward waves of a "
          "nodal diameter are added; those at rest are left out. Orange lines: the natural frequencies of that nodal "
          "diameter. The table "
          "beside it lists the ridges: every wave's peaks over speed.",
      .data = ridge_table(study)};
  set_map_axes(figure.drawing, study);
  std::vector<std::string> titles;
  for (const int n : panels) {
    titles.push_back("nodal diameter " + std::to_string(n));
    figure.pixels.push_back(
        {figure.drawing.name + "_" + std::to_string(n) + ".pixels", part_pixels(study, n, width, height)});
  }
  figure.drawing.values.insert(figure.drawing.values.end(),
                               {{"pixel_columns", width},
                                {"pixel_rows", height},
                                {"panel_columns", columns},
                                {"panel_rows", rows},
                                {"panels", count},
                                {"panel_nodal_diameter", std::vector<double>(panels.begin(), panels.end())},
                                {"panel_title", titles}});
  return figure;
}

}  // namespace tiprub
