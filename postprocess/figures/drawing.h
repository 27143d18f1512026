// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

/// The ends of an axis or of a colour scale. In a script the ends of "speed" are speed_low and speed_high.
struct DrawnRange {
  double low = 0;
  double high = 0;

  /// Widened, if it is too narrow, to a ten-thousandth of its magnitude: to both sides, or upwards from zero. gnuplot
  /// draws no empty range and labels tics with six digits.
  DrawnRange widened() const;
};

/// A value that a script reads by name: a number, a text, a list of either (an array, from 1), or a range.
using ScriptValue = std::variant<int, double, std::string, std::vector<double>, std::vector<std::string>, DrawnRange>;

/// Numbers that a script plots as $name; its sheets are `index 0`, `index 1`, and so on.
struct ScriptTable {
  std::string name;
  std::vector<Eigen::MatrixXd> sheets;
};

/// A sheet of one column.
inline Eigen::MatrixXd as_column(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// A sheet of these rows.
template <std::size_t columns>
Eigen::MatrixXd as_sheet(const std::vector<std::array<double, columns>>& rows) {
  Eigen::MatrixXd sheet(rows.size(), columns);
  for (std::size_t i = 0; i < rows.size(); ++i)
    sheet.row(static_cast<Eigen::Index>(i)) = Eigen::RowVectorXd::Map(rows[i].data(), columns);
  return sheet;
}

/// One picture: a script of scripts/, which decides how it looks, and what that script reads.
struct Drawing {
  std::string name{};    ///< of the files, without ending
  int width = 900;       ///< [px] of the SVG; the PNG has twice as many
  int height = 540;      ///< [px]
  std::string script{};  ///< without ending
  std::vector<std::pair<std::string, ScriptValue>> values{};
  std::vector<ScriptTable> tables{};  ///< a script finds the number of rows in <name>_rows
};

/// The commands that gnuplot executes for a drawing: its values and tables as assignments, then scripts/draw.gp.
std::string prologue(const Drawing& drawing);

/// Quotes a text, which may come from a case, so that gnuplot shows it unchanged. Between single quotes gnuplot
/// neither executes nor replaces anything. Single quotes in the text become an escape between double quotes,
/// characters that enhanced mode would read as markup are escaped, and line ends become blanks.
std::string gnuplot_text(const std::string& text);

/// Raises RunError if gnuplot can't be started.
void require_gnuplot();

/// Draws name.svg and name.png for each drawing in the folder, which that many processes share. Raises RunError with
/// gnuplot's message if one fails or leaves no whole picture, and Interrupted if a signal came. No process outlives
/// the call.
void draw(const std::vector<Drawing>& drawings, const std::filesystem::path& folder, int processes);

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
