// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "postprocess/figures/drawing.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// Colours on a regular grid, as a drawing reads them from `file`; rows go up, columns to the right. They are
/// resampled for the eye, and thrown away after drawing: the numbers are in the figure's table.
struct Pixels {
  std::string file;
  Eigen::MatrixXf values;
};

/// A figure of the report.
struct Figure {
  Drawing drawing;
  std::string title;
  std::string caption;
  Table data{};  ///< what is drawn, as <name>.csv, which the drawing may read
  std::vector<Pixels> pixels{};
  std::string seen{};  ///< what is seen, in words, for those who can't see it; empty: the caption says it
};

/// Gives the figure its pixels, as <name>.pixels; the script finds their counts in pixel_columns and pixel_rows.
void set_pixels(Figure& figure, Eigen::MatrixXf values);

/// Writes the tables and draws the pictures in the folder, two processes at a time.
void draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder,
                  const std::function<void()>& drawn);

}  // namespace tiprub
