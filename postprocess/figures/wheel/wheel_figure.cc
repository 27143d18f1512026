// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/field_figures.h"
#include "postprocess/figures/wheel/wheel_picture.h"

namespace tiprub {

Figure wheel_figure(const FieldStudy& fields, const std::vector<SurfaceFace>& faces) {
  constexpr int width = 900, height = 620;
  const SectorFields& sector = fields.sector;
  SurfacePicture picture(in_pixels(width), in_pixels(height));
  picture.begin_panel(in_pixels(20), in_pixels(15), in_pixels(width - 40), in_pixels(height - 30),
                      wheel_view(fields, usual_tilt));
  draw_wheel(
      picture, sector, faces, [&](int j) { return nodes_of_sector(sector, j); },
      [&](int j) {
        return even(sector.nodes.cols(), j == 0 ? surface_colours::chosen_sector : surface_colours::metal);
      });
  const int nodes = static_cast<int>(sector.nodes.cols()), cells = static_cast<int>(sector.cells.cols());
  Figure figure{.drawing = {.name = "wheel", .width = width, .height = height, .script = "wheel"},
                .title = "The wheel",
                .caption = std::to_string(sector.sector_count) +
                           " sectors; in colour the one that was meshed and reduced (" + std::to_string(nodes) +
                           " nodes, " + std::to_string(cells) + " cells). Seen from the inlet.",
                .data = {{"sectors", "nodes a sector", "cells a sector", "outer radius [m]"},
                         {{sector.sector_count, nodes, cells, outer_radius(sector)}}}};
  set_picture(figure, picture);
  return figure;
}

}  // namespace tiprub
