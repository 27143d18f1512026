// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/axes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr int many_engine_orders = 16;  // beyond that, their labels run into each other
constexpr int modal_line_points = 60;
constexpr double lone_reach = 0.005;  // of a lone speed, to each side

}  // namespace

Eigen::VectorXd rpm_of(const std::vector<SpeedResponse>& speeds) {
  Eigen::VectorXd rpm(static_cast<Eigen::Index>(speeds.size()));
  for (Eigen::Index i = 0; i < rpm.size(); ++i) rpm[i] = speeds[static_cast<std::size_t>(i)].speed * rpm_per_rad_s;
  return rpm;
}

Eigen::VectorXd speeds_rpm(const Study& study) {
  return rpm_of(study.response.speeds);
}

SpeedAxis speed_axis(const Study& study) {
  const Eigen::VectorXd rpm = speeds_rpm(study);
  const Eigen::Index last = rpm.size() - 1;
  if (last == 0) return {(1 - lone_reach) * rpm[0], (1 + lone_reach) * rpm[0]};
  const SpeedAxis axis{rpm[0] - 0.5 * (rpm[1] - rpm[0]), rpm[last] + 0.5 * (rpm[last] - rpm[last - 1])};
  return axis.widened();
}

Eigen::VectorXi nearest_speeds(const Study& study, int columns) {
  const Eigen::VectorXd rpm = speeds_rpm(study), failed = rpm_of(study.failed);
  const SpeedAxis axis = speed_axis(study);
  Eigen::VectorXi nearest(columns);
  for (int column = 0; column < columns; ++column) {
    const double here = axis.low + (axis.high - axis.low) * (column + 0.5) / columns;
    Eigen::Index index = 0;
    const double distance = (rpm.array() - here).abs().minCoeff(&index);
    const bool in_gap = failed.size() > 0 && (failed.array() - here).abs().minCoeff() < distance;
    nearest[column] = in_gap ? -1 : static_cast<int>(index);
  }
  return nearest;
}

int drawn_families(const Study& study, int nodal_diameter) {
  return std::min(study.parameters.families, study.curves.families(nodal_diameter));
}

std::vector<Crossing> drawn_crossings(const Study& study, const std::vector<Crossing>& crossings) {
  std::vector<Crossing> drawn;
  std::copy_if(crossings.begin(), crossings.end(), std::back_inserter(drawn), [&](const Crossing& crossing) {
    return crossing.family < study.parameters.families && crossing.engine_order <= study.parameters.engine_order_max;
  });
  return drawn;
}

void set_speed_axis(Drawing& drawing, const SpeedAxis& axis) {
  drawing.values.insert(drawing.values.end(), {{"speed", axis}});
}

void set_engine_orders(Drawing& drawing, const Study& study) {
  const int last = study.parameters.engine_order_max;
  const int step = last <= many_engine_orders ? 1 : std::max(study.response.scene.lobes, last / many_engine_orders);
  drawing.values.insert(drawing.values.end(), {{"engine_order_step", step}, {"engine_order_last", last}});
}

void set_modes(Drawing& drawing, const Study& study, const SpeedAxis& axis) {
  const int nodal_diameters = study.model.nodal_diameter_max() + 1, families = study.parameters.families;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(modal_line_points, 1 + nodal_diameters * families, std::nan(""));
  rows.col(0) = Eigen::VectorXd::LinSpaced(modal_line_points, axis.low, axis.high);
  for (int n = 0; n < nodal_diameters; ++n)
    for (int family = 0; family < drawn_families(study, n); ++family)
      for (int i = 0; i < modal_line_points; ++i)
        rows(i, 1 + n * families + family) = study.curves.frequency(n, family, rows(i, 0) / rpm_per_rad_s);
  drawing.values.insert(drawing.values.end(), {{"nodal_diameters", nodal_diameters}, {"families", families}});
  drawing.tables.push_back({"modes", {rows}});
}

}  // namespace tiprub
