// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

/// [Hz] of the drawn families at the end of the simulated speeds.
double highest_frequency(const Study& study) {
  double highest = 0;
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    for (int family = 0; family < drawn_families(study, n); ++family)
      highest = std::max(highest, study.curves.frequency(n, family, study.range.high));
  return highest;
}

/// Speed [rpm], frequency [Hz].
Eigen::MatrixXd places(const std::vector<Crossing>& crossings) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(crossings.size()), 2);
  for (std::size_t i = 0; i < crossings.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) << crossings[i].speed * rpm_per_rad_s, crossings[i].frequency;
  return rows;
}

/// The drawing's table of modes, one line a point.
Table mode_table(const Study& study, const Drawing& drawing) {
  const Eigen::MatrixXd& modes = drawing.tables.back().sheets.front();
  Table table{{"speed [rpm]", "nodal diameter", "family", "frequency [Hz]"}, {}};
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    for (int family = 0; family < drawn_families(study, n); ++family)
      for (Eigen::Index i = 0; i < modes.rows(); ++i)
        table.rows.push_back({modes(i, 0), n, family + 1, modes(i, 1 + n * drawn_families(study) + family)});
  return table;
}

}  // namespace

Figure campbell_figure(const Study& study) {
  constexpr double headroom = 1.12;  // of the highest drawn frequency
  const SpeedAxis axis{0, speed_axis(study).high};
  Figure figure{
      .drawing = {.name = "campbell",
                  .width = 1000,
                  .height = 640,
                  .script = "campbell",
                  .values = {{"frequency", DrawnRange{0, headroom * highest_frequency(study)}},
                             {"range",
                              DrawnRange{study.range.low * rpm_per_rad_s, study.range.high * rpm_per_rad_s}}},
                  .tables = {{"aliased", {places(drawn_crossings(study, study.aliased))}},
                             {"equation_2", {places(drawn_crossings(study, study.equation_2))}}}},
      .title = "Campbell diagram",
      .caption =
          "Natural frequencies in the rotor frame over speed by nodal diameter, all families that make critical "
          "speeds, and "
          "engine-order lines. Shaded: the simulated speeds. Circles: crossings that the linear rule with "
          "aliasing lists (f = k \xC3\x97 lobes \xC3\x97 \xCE\xA9 on the nodal diameter of eq. 17); squares: "
          "those of eq. 2; diamonds: the critical speeds that were computed, at the frequency of the wave that makes "
          "them (at the upper edge, where it is higher)."};
  set_speed_axis(figure.drawing, axis);
  set_engine_orders(figure.drawing, study);
  set_critical_speeds(figure.drawing, study, headroom * highest_frequency(study));
  set_modes(figure.drawing, study, axis);
  figure.data = mode_table(study, figure.drawing);
  return figure;
}

}  // namespace tiprub
