// SPDX-License-Identifier: GPL-3.0-or-later
// Natural frequencies over speed, and over nodal diameter.
#include <algorithm>
#include <cmath>

#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

constexpr double headroom = 1.12;  // of the highest drawn frequency

/// [Hz] of the drawn families at the end of the simulated speeds.
double highest_frequency(const SpeedFrame& frame) {
  double highest = 0;
  for (int n = 0; n < frame.nodal_diameters(); ++n)
    for (int family = 0; family < frame.families_at(n); ++family)
      highest = std::max(highest, frame.curves.frequency(n, family, frame.range.high));
  return highest;
}

/// Speed [rpm], frequency [Hz].
Eigen::MatrixXd places(const std::vector<Crossing>& crossings) {
  std::vector<std::array<double, 2>> rows;
  for (const Crossing& crossing : crossings) rows.push_back({crossing.speed * rpm_per_rad_s, crossing.frequency});
  return as_sheet(rows);
}

/// The drawing's table of modes, one line a point.
Table mode_table(const SpeedFrame& frame, const Drawing& drawing) {
  const Eigen::MatrixXd& modes = drawing.tables.back().sheets.front();
  Table table{{"speed [rpm]", "nodal diameter", "family", "frequency [Hz]"}, {}};
  for (int n = 0; n < frame.nodal_diameters(); ++n)
    for (int family = 0; family < frame.families_at(n); ++family)
      for (Eigen::Index i = 0; i < modes.rows(); ++i)
        table.rows.push_back({modes(i, 0), n, family + 1, modes(i, 1 + n * frame.families + family)});
  return table;
}

/// Nodal diameter, then the first families [Hz] at a speed; a missing family is NaN.
Eigen::MatrixXd veering_rows(const SpeedFrame& frame, int families, double speed) {
  const int count = frame.nodal_diameters();
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(count, 1 + families, std::nan(""));
  for (int n = 0; n < count; ++n) {
    rows(n, 0) = n;
    for (int family = 0; family < std::min(families, frame.curves.families(n)); ++family)
      rows(n, 1 + family) = frame.curves.frequency(n, family, speed);
  }
  return rows;
}

/// A curve where its family is named.
struct NamedCurve {
  double frequency = 0;  ///< [Hz]
  int family = 0;        ///< from 1
};

/// Frequency [Hz], first and last family of each name; curves that are closer than a name is high share one.
Eigen::MatrixXd family_rows(std::vector<NamedCurve> curves, double frequency_high) {
  constexpr double name_height = 0.033;  // of the frequencies that are drawn
  std::ranges::sort(curves, {}, &NamedCurve::frequency);
  std::vector<std::array<double, 3>> names;
  for (const auto& [frequency, family] : curves) {
    if (names.empty() || frequency - names.back()[0] > name_height * frequency_high)
      names.push_back({frequency, static_cast<double>(family), static_cast<double>(family)});
    names.back()[1] = std::min<double>(names.back()[1], family);
    names.back()[2] = std::max<double>(names.back()[2], family);
  }
  return as_sheet(names);
}

/// Names at the last nodal diameter of veering_rows().
Eigen::MatrixXd last_families(const Eigen::MatrixXd& rows, double frequency_high) {
  std::vector<NamedCurve> curves;
  for (Eigen::Index k = 1; k < rows.cols(); ++k)
    if (const double frequency = rows(rows.rows() - 1, k); std::isfinite(frequency))
      curves.push_back({frequency, static_cast<int>(k)});
  return family_rows(curves, frequency_high);
}

/// Names at the lowest drawn speed, of the nodal diameters that move.
Eigen::MatrixXd first_families(const SpeedFrame& frame, const DrawnRange& axis, double frequency_high) {
  std::vector<NamedCurve> curves;
  for (const int n : frame.moving)
    for (int family = 0; family < frame.families_at(n); ++family)
      curves.push_back({frame.curves.frequency(n, family, axis.low / rpm_per_rad_s), family + 1});
  return family_rows(curves, frequency_high);
}

/// How many engine orders stay below a frequency: at least one, and not more than can be told apart.
int engine_orders_below(double frequency_high, double speed) {
  constexpr double most = 2000;
  return static_cast<int>(std::clamp(frequency_high / (speed * hz_per_rad_s), 1.0, most));
}

/// Engine orders from 0 that stay below a frequency: nodal diameter, frequency [Hz], engine order, and 1 if the
/// casing drives it.
Eigen::MatrixXd zigzag_rows(const SpeedFrame& frame, double speed, double frequency_high) {
  const int last = engine_orders_below(frequency_high, speed), lobes = frame.lobes;
  Eigen::MatrixXd rows(last + 1, 4);
  for (int order = 0; order <= last; ++order)
    rows.row(order) << aliased_nodal_diameter(order, frame.sector_count), order * speed * hz_per_rad_s, order,
        order > 0 && lobes > 0 && order % lobes == 0 ? 1 : 0;
  return rows;
}

/// The lowest critical speed other than the shown one; the highest speed if there is none.
double second_speed(const SpeedFrame& frame, double shown) {
  for (const CriticalSpeed& critical : frame.critical)
    if (critical.speed != shown) return critical.speed;
  return frame.range.high;
}

double highest(const std::vector<Eigen::MatrixXd>& sheets) {
  double frequency = 0;
  for (const Eigen::MatrixXd& rows : sheets)
    for (const double value : rows.rightCols(rows.cols() - 1).reshaped())
      if (std::isfinite(value)) frequency = std::max(frequency, value);
  return frequency;
}

Table veering_table(int families, const std::vector<double>& speeds, const std::vector<Eigen::MatrixXd>& sheets) {
  Table table{{"speed [rpm]", "nodal diameter"}, {}};
  for (int family = 1; family <= families; ++family)
    table.header.push_back("family " + std::to_string(family) + " [Hz]");
  for (std::size_t i = 0; i < speeds.size(); ++i)
    for (Eigen::Index n = 0; n < sheets[i].rows(); ++n) {
      table.rows.push_back({speeds[i] * rpm_per_rad_s, static_cast<int>(n)});
      for (Eigen::Index k = 1; k < sheets[i].cols(); ++k) table.rows.back().push_back(number_if_any(sheets[i](n, k)));
    }
  return table;
}

}  // namespace

Figure campbell_figure(const SpeedFrame& frame, const LinearRules& rules) {
  const DrawnRange axis{0, frame.axis.high};
  const double frequency_high = headroom * highest_frequency(frame);
  Figure figure = listed_figure("campbell");
  figure.drawing.values = {{"speed", axis},
                           {"frequency", DrawnRange{0, frequency_high}},
                           {"range", DrawnRange{frame.range.low * rpm_per_rad_s, frame.range.high * rpm_per_rad_s}}};
  figure.drawing.tables = {{"aliased", {places(drawn_crossings(frame, rules.aliased))}},
                           {"equation_2", {places(drawn_crossings(frame, rules.equation_2))}},
                           {"family_labels", {first_families(frame, axis, frequency_high)}}};
  set_engine_orders(figure.drawing, frame);
  set_critical_speeds(figure.drawing, frame, frequency_high);
  set_modes(figure.drawing, frame, axis);
  std::vector<double> moves(static_cast<std::size_t>(frame.nodal_diameters()), 0);
  for (const int n : frame.moving) moves[static_cast<std::size_t>(n)] = 1;
  figure.drawing.values.emplace_back("moves", moves);
  figure.data = mode_table(frame, figure.drawing);
  return figure;
}

Figure interference_figure(const SpeedFrame& frame, double shown, int asked_families) {
  constexpr int fewest_families = 5;  // so that veering is seen
  const int families = std::max(fewest_families, asked_families);
  const std::vector<double> speeds = {0.0, shown, second_speed(frame, shown)};
  std::vector<Eigen::MatrixXd> modes, zigzags;
  for (const double speed : speeds) modes.push_back(veering_rows(frame, families, speed));
  const double frequency_high = headroom * highest(modes);
  std::vector<double> engine_orders;
  std::vector<std::string> titles;
  for (const double speed : {speeds[1], speeds[2]}) {
    zigzags.push_back(zigzag_rows(frame, speed, frequency_high));
    engine_orders.push_back(engine_orders_below(frequency_high, speed));
    titles.push_back("at " + rpm_text(speed));
  }
  Figure figure = listed_figure("interference");
  figure.drawing.values = {{"nodal_diameters", frame.nodal_diameters()},
                           {"sectors", frame.sector_count},
                           {"families", families},
                           {"frequency", DrawnRange{0, frequency_high}},
                           {"panel_title", titles},
                           {"engine_orders", engine_orders}};
  figure.drawing.tables = {
      {"modes", modes},
      {"zigzag", zigzags},
      {"family_labels", {last_families(modes[1], frequency_high), last_families(modes[2], frequency_high)}}};
  figure.data = veering_table(families, speeds, modes);
  return figure;
}

}  // namespace tiprub::postprocess
