// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/figure.h"

#include <nlohmann/json.hpp>
#include <ostream>

#include "cases/program/output_file.h"
#include "cases/program/signal_cleanup.h"
#include "embedded/figure_list.h"
#include "postprocess/figures/drawing.h"

namespace fs = std::filesystem;

namespace tiprub::postprocess {

namespace {

constexpr int gnuplot_processes = 2;

void write_pixels(const Pixels& pixels, const fs::path& folder) {
  using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const RowMajor values = pixels.values;
  write_file(folder / pixels.file, [&](std::ostream& stream) {
    stream.write(reinterpret_cast<const char*>(values.data()),
                 static_cast<std::streamsize>(sizeof(float) * static_cast<std::size_t>(values.size())));
  });
}

}  // namespace

Figure listed_figure(const std::string& name, const std::map<std::string, std::string>& values) {
  static const nlohmann::json list = nlohmann::json::parse(embedded::figure_list::figures_json, nullptr, true, true);
  const nlohmann::json& entry = list.at(name);
  std::string caption;
  for (const nlohmann::json& line : entry.at("caption"))
    caption += (caption.empty() ? "" : " ") + line.get<std::string>();
  const std::string text = filled(entry.at("title").get<std::string>() + "\n" + caption, values);
  const std::size_t title_end = text.find('\n');
  return {.drawing = {.name = name,
                      .width = entry.at("size").at(0),
                      .height = entry.at("size").at(1),
                      .script = entry.value("script", name)},
          .title = text.substr(0, title_end),
          .caption = text.substr(title_end + 1)};
}

void set_pixels(Figure& figure, Eigen::MatrixXf values) {
  figure.drawing.values.insert(figure.drawing.values.end(), {{"pixel_columns", static_cast<int>(values.cols())},
                                                             {"pixel_rows", static_cast<int>(values.rows())}});
  figure.pixels.push_back({figure.drawing.name + ".pixels", std::move(values)});
}

void draw_figures(const std::vector<Figure>& figures, const fs::path& folder) {
  fs::create_directories(folder);
  std::vector<Drawing> drawings;
  for (const Figure& figure : figures) {
    stop_if_interrupted();
    write_csv(figure.data, folder / (figure.drawing.name + ".csv"));
    for (const Pixels& pixels : figure.pixels) write_pixels(pixels, folder);
    drawings.push_back(figure.drawing);
  }
  draw(drawings, folder, gnuplot_processes);
  for (const Figure& figure : figures)
    for (const Pixels& pixels : figure.pixels) fs::remove(folder / pixels.file);
}

}  // namespace tiprub::postprocess
