// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/figure.h"

#include <fstream>

#include "cases/program/errors.h"
#include "postprocess/tables/interruption.h"

namespace fs = std::filesystem;

namespace tiprub {

namespace {

constexpr int gnuplot_processes = 2;

void write_pixels(const Pixels& pixels, const fs::path& folder) {
  using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const RowMajor values = pixels.values;
  std::ofstream stream(folder / pixels.file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(sizeof(float) * static_cast<std::size_t>(values.size())));
  stream.close();
  if (!stream) throw RunError((folder / pixels.file).string() + ": can't be written");
}

}  // namespace

std::vector<Figure> all_figures(const Study& study) {
  std::vector<Figure> figures = {interaction_map_figure(study),
                                 response_figure(study),
                                 interaction_map_parts_figure(study),
                                 contact_map_figure(study, TipEdge::leading),
                                 contact_map_figure(study, TipEdge::trailing),
                                 campbell_figure(study),
                                 interference_figure(study),
                                 tip_motion_figure(study),
                                 tip_spectrum_figure(study),
                                 contact_force_figure(study),
                                 force_of_sectors_figure(study),
                                 force_spectrum_figure(study),
                                 harmonic_bars_figure(study),
                                 nodal_diameter_tracking_figure(study),
                                 engine_order_tracking_figure(study),
                                 waterfall_figure(study),
                                 casing_figure(study)};
  if (!study.sweeps.empty()) figures.insert(figures.begin() + 2, sweeps_figure(study));
  return figures;
}

void draw_figures(const std::vector<Figure>& figures, const fs::path& folder, const std::function<void()>& drawn) {
  std::vector<Drawing> drawings;
  for (const Figure& figure : figures) {
    stop_if_interrupted();
    write_csv(figure.data, folder / (figure.drawing.name + ".csv"));
    for (const Pixels& pixels : figure.pixels) write_pixels(pixels, folder);
    drawings.push_back(figure.drawing);
  }
  draw(drawings, folder, gnuplot_processes, drawn);
  for (const Figure& figure : figures)
    for (const Pixels& pixels : figure.pixels) fs::remove(folder / pixels.file);
}

}  // namespace tiprub
