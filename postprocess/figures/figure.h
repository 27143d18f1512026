// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/figures/gnuplot.h"
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
  Table data;  ///< what is drawn, as <name>.csv
  std::vector<Pixels> pixels;
  std::vector<std::string> fields;  ///< the same for ParaView, if there is: files in the report's folder
};

// One builder a figure; each says in its caption what is drawn and how.
Figure interaction_map_figure(const Study& study);            ///< paper, fig. 22a
Figure interaction_map_parts_figure(const Study& study);      ///< paper, fig. 22b-g
Figure waterfall_figure(const Study& study);                  ///< paper, fig. 18a
Figure response_figure(const Study& study);                   ///< tip amplitude over speed, peaks labelled
Figure contact_map_figure(const Study& study, TipEdge edge);  ///< paper, fig. 24
Figure casing_figure(const Study& study);                     ///< paper, fig. 21
Figure contact_force_figure(const Study& study);              ///< paper, figs. 14, 15
Figure campbell_figure(const Study& study);                   ///< paper, fig. 8
Figure interference_figure(const Study& study);               ///< paper, figs. 4, 13
Figure tip_motion_figure(const Study& study);                 ///< paper, fig. 10
Figure tip_spectrum_figure(const Study& study);               ///< paper, fig. 11, made directional
Figure force_of_sectors_figure(const Study& study);           ///< paper, fig. 16
Figure force_spectrum_figure(const Study& study);             ///< paper, fig. 17, made directional
Figure harmonic_bars_figure(const Study& study);              ///< paper, fig. 20
Figure sweeps_figure(const Study& study);                     ///< where sweeps up and down differ
Figure nodal_diameter_tracking_figure(const Study& study);    ///< paper, fig. 25
Figure engine_order_tracking_figure(const Study& study);      ///< paper, fig. 26

/// All of them, in the order of the page.
std::vector<Figure> all_figures(const Study& study);

/// Writes the tables and draws the pictures in the folder, two processes at a time.
void draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder,
                  const std::function<void()>& drawn);

}  // namespace tiprub
