// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/axes.h"

#include <algorithm>
#include <iterator>

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

constexpr int many_engine_orders = 16;  // beyond that, their labels run into each other
constexpr int modal_line_points = 60;
constexpr double lone_reach = 0.005;  // of a lone speed, to each side

DrawnRange axis_of(const Eigen::VectorXd& rpm) {
  const Eigen::Index last = rpm.size() - 1;
  if (last == 0) return {(1 - lone_reach) * rpm[0], (1 + lone_reach) * rpm[0]};
  return DrawnRange{rpm[0] - 0.5 * (rpm[1] - rpm[0]), rpm[last] + 0.5 * (rpm[last] - rpm[last - 1])}.widened();
}

Eigen::VectorXd outside_validity(const Study& study) {
  std::vector<double> outside;
  for (std::size_t i = 0; i < study.gap.size(); ++i)
    if (study.gap[i].beyond()) outside.push_back(study.response.speeds[i].speed * rpm_per_rad_s);
  return as_column(outside);
}

}  // namespace

Eigen::VectorXd rpm_of(const std::vector<SpeedResponse>& speeds) {
  Eigen::VectorXd rpm(static_cast<Eigen::Index>(speeds.size()));
  for (Eigen::Index i = 0; i < rpm.size(); ++i) rpm[i] = speeds[static_cast<std::size_t>(i)].speed * rpm_per_rad_s;
  return rpm;
}

std::string of_main_blade(const ContactLine& contact) {
  return contact.splitter_nodes > 0 ? " of the main blade" : "";
}

Eigen::VectorXi nearest_speeds(const Eigen::VectorXd& speeds, const Eigen::VectorXd& failed, const DrawnRange& axis,
                               int columns) {
  const Eigen::Index last = speeds.size() - 1;
  const double below = last > 0 ? 0.5 * (speeds[1] - speeds[0]) : axis.high,
               above = last > 0 ? 0.5 * (speeds[last] - speeds[last - 1]) : axis.high,
               slack = 1e-4 * axis.high;  // an axis of hardly any width is drawn wider
  Eigen::VectorXi nearest(columns);
  for (int column = 0; column < columns; ++column) {
    const double here = axis.low + (axis.high - axis.low) * (column + 0.5) / columns;
    Eigen::Index index = 0;
    const double distance = (speeds.array() - here).abs().minCoeff(&index);
    const bool in_gap = failed.size() > 0 && (failed.array() - here).abs().minCoeff() < distance;
    const bool beyond = here < speeds[0] - below - slack || here > speeds[last] + above + slack;
    nearest[column] = in_gap || beyond ? -1 : static_cast<int>(index);
  }
  return nearest;
}

int SpeedFrame::families_at(int nodal_diameter) const {
  return std::min(families, curves.families(nodal_diameter));
}

SpeedFrame speed_frame(const Study& study) {
  const Eigen::VectorXd rpm = rpm_of(study.response.speeds);
  int families = study.parameters.families;
  for (const CriticalSpeed& critical : study.critical)
    families = std::max(families, critical.naming_wave().family + 1);
  return {axis_of(rpm),
          rpm,
          rpm_of(study.failed),
          outside_validity(study),
          study.range,
          study.curves,
          study.model.sector_count,
          study.response.scene.lobes,
          families,
          study.parameters.engine_order_max,
          study.critical,
          study.response.scene.nodal_diameters};
}

std::vector<Crossing> drawn_crossings(const SpeedFrame& frame, const std::vector<Crossing>& crossings) {
  std::vector<Crossing> drawn;
  std::copy_if(crossings.begin(), crossings.end(), std::back_inserter(drawn), [&](const Crossing& crossing) {
    return crossing.family < frame.families && crossing.engine_order <= frame.engine_order_max;
  });
  return drawn;
}

void set_engine_orders(Drawing& drawing, const SpeedFrame& frame) {
  const int last = frame.engine_order_max;
  const int step = last <= many_engine_orders ? 1 : std::max(frame.lobes, last / many_engine_orders);
  drawing.values.insert(drawing.values.end(), {{"engine_order_step", step}, {"engine_order_last", last}});
}

void set_critical_speeds(Drawing& drawing, const SpeedFrame& frame, double frequency_high) {
  std::vector<std::array<double, 2>> rows;
  for (const CriticalSpeed& critical : frame.critical) {
    const double frequency = critical.naming_wave().engine_order * critical.speed * hz_per_rad_s;
    rows.push_back({critical.speed * rpm_per_rad_s, std::min(frequency, frequency_high)});
  }
  drawing.tables.push_back({"critical", {as_sheet(rows)}});
}

void set_modes(Drawing& drawing, const SpeedFrame& frame, const DrawnRange& axis) {
  const int nodal_diameters = frame.nodal_diameters(), families = frame.families;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(modal_line_points, 1 + nodal_diameters * families, std::nan(""));
  rows.col(0) = Eigen::VectorXd::LinSpaced(modal_line_points, axis.low, axis.high);
  for (int n = 0; n < nodal_diameters; ++n)
    for (int family = 0; family < frame.families_at(n); ++family)
      for (int i = 0; i < modal_line_points; ++i)
        rows(i, 1 + n * families + family) = frame.curves.frequency(n, family, rows(i, 0) / rpm_per_rad_s);
  drawing.values.insert(drawing.values.end(), {{"nodal_diameters", nodal_diameters}, {"families", families}});
  drawing.tables.push_back({"modes", {rows}});
}

}  // namespace tiprub::postprocess
