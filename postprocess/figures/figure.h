// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "postprocess/figures/drawing.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

/// Colours on a regular grid, which a drawing reads from `file`; rows go up, columns to the right. They are
/// resampled for display and deleted after drawing, because the figure's table holds the numbers.
struct Pixels {
  std::string file;
  Eigen::MatrixXf values;
};

/// A figure of the report.
struct Figure {
  Drawing drawing;
  std::string title;
  std::string caption;
  Table data{};  ///< what is drawn; written as <name>.csv, which the drawing may read
  std::vector<Pixels> pixels{};
};

/// A figure as figures.json lists it, with name, size, script, title and caption; each {{word}} is replaced by its
/// value.
Figure listed_figure(const std::string& name, const std::map<std::string, std::string>& values = {});

/// Gives the figure its pixels, as <name>.pixels; the script finds their counts in pixel_columns and pixel_rows.
void set_pixels(Figure& figure, Eigen::MatrixXf values);

/// Writes the tables and draws the pictures in the folder, two processes at a time.
void draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder);

}  // namespace tiprub::postprocess
