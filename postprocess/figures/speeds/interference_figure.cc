// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double headroom = 1.12;  // of the highest drawn frequency

/// The paper's fig. 4 has five.
int veering_families(const Study& study) {
  constexpr int fewest = 5;
  return std::max(fewest, study.parameters.families);
}

/// Nodal diameter, then the first families [Hz] at a speed; a missing family is NaN.
Eigen::MatrixXd veering_rows(const Study& study, double speed) {
  const int count = study.model.nodal_diameter_max() + 1, families = veering_families(study);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(count, 1 + families, std::nan(""));
  for (int n = 0; n < count; ++n) {
    rows(n, 0) = n;
    for (int family = 0; family < std::min(families, study.curves.families(n)); ++family)
      rows(n, 1 + family) = study.curves.frequency(n, family, speed);
  }
  return rows;
}

/// How many engine orders stay below a frequency, one at least, and at most as many as lines can be told apart.
int engine_orders_below(double frequency_high, double speed) {
  constexpr double most = 2000;
  return static_cast<int>(std::clamp(frequency_high / (speed * hz_per_rad_s), 1.0, most));
}

/// Engine orders 0 .. that stay below a frequency: nodal diameter, frequency [Hz], engine order, driven by the
/// casing.
Eigen::MatrixXd zigzag_rows(const Study& study, double speed, double frequency_high) {
  const int last = engine_orders_below(frequency_high, speed), lobes = study.response.scene.lobes;
  Eigen::MatrixXd rows(last + 1, 4);
  for (int order = 0; order <= last; ++order)
    rows.row(order) << aliased_nodal_diameter(order, study.model.sector_count), order * speed * hz_per_rad_s, order,
        order > 0 && lobes > 0 && order % lobes == 0 ? 1 : 0;
  return rows;
}

/// The lowest critical speed, where the zig-zag has its many legs; the highest speed if there is none other.
double second_speed(const Study& study) {
  for (const CriticalSpeed& critical : study.critical)
    if (critical.speed != study.shown_response().speed) return critical.speed;
  return study.range.high;
}

double highest(const std::vector<Eigen::MatrixXd>& sheets) {
  double frequency = 0;
  for (const Eigen::MatrixXd& rows : sheets)
    for (const double value : rows.rightCols(rows.cols() - 1).reshaped())
      if (std::isfinite(value)) frequency = std::max(frequency, value);
  return frequency;
}

Table veering_table(const Study& study, const std::vector<double>& speeds,
                    const std::vector<Eigen::MatrixXd>& sheets) {
  Table table{{"speed [rpm]", "nodal diameter"}, {}};
  for (int family = 1; family <= veering_families(study); ++family)
    table.header.push_back("family " + std::to_string(family) + " [Hz]");
  for (std::size_t i = 0; i < speeds.size(); ++i)
    for (Eigen::Index n = 0; n < sheets[i].rows(); ++n) {
      table.rows.push_back({speeds[i] * rpm_per_rad_s, static_cast<int>(n)});
      for (Eigen::Index k = 1; k < sheets[i].cols(); ++k) table.rows.back().push_back(number_if_any(sheets[i](n, k)));
    }
  return table;
}

}  // namespace

Figure interference_figure(const Study& study) {
  const std::vector<double> speeds = {0.0, study.shown_response().speed, second_speed(study)};
  std::vector<Eigen::MatrixXd> modes, zigzags;
  for (const double speed : speeds) modes.push_back(veering_rows(study, speed));
  const double frequency_high = headroom * highest(modes);
  std::vector<double> engine_orders;
  std::vector<std::string> titles;
  for (const double speed : {speeds[1], speeds[2]}) {
    zigzags.push_back(zigzag_rows(study, speed, frequency_high));
    engine_orders.push_back(engine_orders_below(frequency_high, speed));
    titles.push_back("at " + rpm_text(speed));
  }
  return {.drawing = {.name = "interference",
                      .width = 1050,
                      .height = 580,
                      .script = "interference",
                      .values = {{"nodal_diameters", study.model.nodal_diameter_max() + 1},
                                 {"sectors", study.model.sector_count},
                                 {"families", veering_families(study)},
                                 {"frequency", DrawnRange{0, frequency_high}},
                                 {"panel_title", titles},
                                 {"engine_orders", engine_orders}},
                      .tables = {{"modes", modes}, {"zigzag", zigzags}}},
          .title = "Nodal diameter over frequency",
          .caption =
              "The families over the nodal diameter, at rest and at two speeds: the one whose motion is shown "
              "below, and the lowest critical speed. The zig-zag is where the sectors see the engine orders "
              "(eq. 17); a resonance threatens where one of its orange corners, the multiples of the lobes, "
              "lies on a mode.",
          .data = veering_table(study, speeds, modes)};
}

}  // namespace tiprub
