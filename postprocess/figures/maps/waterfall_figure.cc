// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/maps/map_picture.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double smallest_amplitude = 1e-6;  // [mm] of a scale, where nothing moves

int drawn_lines(const Study& study, const MapColumn& column) {
  return std::min(column.spectrum.lines() - 1, study.parameters.engine_order_max * column.spectrum.revolutions);
}

/// Frequency [Hz], amplitude [mm]: each line of the spectrum as a narrow triangle.
Eigen::MatrixXd outline(const Study& study, const MapColumn& column) {
  const int last = drawn_lines(study, column);
  const double hz_per_order = column.speed * hz_per_rad_s;
  const double half_width = line_half_width(column.spectrum) * hz_per_order;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3 * last + 2, 2);
  for (int line = 1; line <= last; ++line) {
    const double frequency = column.spectrum.engine_order(line) * hz_per_order;
    rows.block<3, 1>(3 * line - 2, 0) << frequency - half_width, frequency, frequency + half_width;
    rows(3 * line - 1, 1) = column.total[line] * mm_per_m;
  }
  rows(3 * last + 1, 0) = map_frequency_high(study);
  return rows;
}

}  // namespace

Figure waterfall_figure(const Study& study) {
  Figure figure{.drawing = {.name = "waterfall", .width = 900, .height = 640, .script = "waterfall"},
                .title = "Waterfall",
                .caption =
                    "The spectra of the interaction map one above the other, linear in amplitude, which the bar at "
                    "the right measures; grey: engine orders. The largest line is " +
                    fixed(study.map.largest() * mm_per_m, 3) + " mm high.",
                .data = {{"speed [rpm]", "frequency [Hz]", "total [mm]"}, {}}};
  std::vector<double> speeds;
  ScriptTable spectra{"spectra", {}};
  for (auto column = study.map.columns.rbegin(); column != study.map.columns.rend(); ++column) {
    speeds.push_back(column->speed * rpm_per_rad_s);
    spectra.sheets.push_back(outline(study, *column));
    for (int line = 1; line <= drawn_lines(study, *column); ++line)
      figure.data.rows.push_back({speeds.back(), column->spectrum.engine_order(line) * column->speed * hz_per_rad_s,
                                  column->total[line] * mm_per_m});
  }
  set_speed_axis(figure.drawing, speed_axis(study));
  set_engine_orders(figure.drawing, study);
  figure.drawing.values.insert(
      figure.drawing.values.end(),
      {{"frequency", DrawnRange{0, map_frequency_high(study)}},
       {"amplitude", DrawnRange{0, std::max(study.map.largest() * mm_per_m, smallest_amplitude)}},
       {"speeds", static_cast<int>(speeds.size())},
       {"speed", speeds}});
  figure.drawing.tables.push_back(std::move(spectra));
  return figure;
}

}  // namespace tiprub
