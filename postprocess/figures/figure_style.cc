// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/figure_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "postprocess/tables/units.h"

namespace tiprub::style {

namespace {

constexpr double seconds_per_minute = 60.0;
constexpr int many_engine_orders = 16;  // beyond that, their labels run into each other
constexpr int modal_line_points = 60;

/// The usual distance between neighbouring speeds [rpm]; a lone speed gets a hundredth of itself.
double speed_step(const Eigen::VectorXd& rpm) {
  if (rpm.size() < 2) return 0.01 * rpm[0];
  std::vector<double> steps;
  for (Eigen::Index i = 1; i < rpm.size(); ++i) steps.push_back(rpm[i] - rpm[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

}  // namespace

std::string base() {
  return "set border 31 linewidth 0.8 linecolor rgb '#444444'\n"
         "set tics nomirror out scale 0.6 textcolor rgb '#222222'\n"
         "set grid linetype 1 linewidth 0.4 linecolor rgb '#dddddd'\n"
         "set datafile missing 'NaN'\n"
         "set key noautotitle samplen 2 spacing 1.1 font ',12'\n";
}

std::string amplitude_palette() {
  return "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', "
         "6 '#35b779', 7 '#6ece58', 8 '#b5de2b', 9 '#fde725')\n";
}

std::string missing_background() {
  return "set object 99 rectangle from graph 0,0 to graph 1,1 fillcolor rgb '#d9d9d9' fillstyle solid noborder "
         "behind\n";
}

std::string contact_palette() {
  return "set palette defined (0 '#ffffff', 1 '#c6dbef', 2 '#6baed6', 3 '#2171b5', 4 '#08306b')\n";
}

std::string colour(int index) {
  constexpr std::array<const char*, 8> colours = {"#000000", "#e69f00", "#0072b2", "#cc79a7",
                                                  "#d55e00", "#009e73", "#56b4e9", "#8c6d1f"};
  return colours[static_cast<std::size_t>(index) % colours.size()];
}

std::string range(const std::string& axis, double low, double high) {
  std::ostringstream out;
  out.precision(10);
  out << "set " << axis << "range [" << low << ":" << high << "]\n";
  return out.str();
}

std::string block(const std::string& name, const Eigen::MatrixXd& rows) {
  std::ostringstream out;
  out.precision(8);
  out << "$" << name << " << EOD\n";
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (Eigen::Index k = 0; k < rows.cols(); ++k) {
      if (std::isfinite(rows(i, k)))
        out << rows(i, k);
      else
        out << "NaN";
      out << (k + 1 < rows.cols() ? ' ' : '\n');
    }
  out << "EOD\n";
  return out.str();
}

Eigen::VectorXd speeds_rpm(const Study& study) {
  Eigen::VectorXd rpm(static_cast<Eigen::Index>(study.response.speeds.size()));
  for (Eigen::Index i = 0; i < rpm.size(); ++i)
    rpm[i] = study.response.speeds[static_cast<std::size_t>(i)].speed * rpm_per_rad_s;
  return rpm;
}

SpeedAxis speed_axis(const Study& study) {
  const Eigen::VectorXd rpm = speeds_rpm(study);
  const double half = 0.5 * speed_step(rpm);
  return {rpm[0] - half, rpm[rpm.size() - 1] + half};
}

Eigen::VectorXi nearest_speeds(const Study& study, int columns) {
  constexpr double reach = 0.75;  // of the usual step: neighbours meet, a missing speed leaves a gap
  const Eigen::VectorXd rpm = speeds_rpm(study);
  const SpeedAxis axis = speed_axis(study);
  const double step = speed_step(rpm);
  Eigen::VectorXi nearest(columns);
  for (int column = 0; column < columns; ++column) {
    const double here = axis.low + (axis.high - axis.low) * (column + 0.5) / columns;
    Eigen::Index index = 0;
    const double distance = (rpm.array() - here).abs().minCoeff(&index);
    nearest[column] = distance <= reach * step ? static_cast<int>(index) : -1;
  }
  return nearest;
}

std::vector<int> drawn_engine_orders(const Study& study) {
  const int last = study.parameters.engine_order_max;
  const int step = last <= many_engine_orders ? 1 : std::max(study.response.scene.lobes, last / many_engine_orders);
  std::vector<int> orders;
  for (int order = step; order <= last; order += step) orders.push_back(order);
  return orders;
}

std::string engine_order_labels(const Study& study, const SpeedAxis& axis, double frequency_max) {
  constexpr double label_width = 0.05;  // of the axis; labels on top that would run into each other are left out
  std::ostringstream out;
  out.precision(8);
  double free_below = axis.high + label_width * (axis.high - axis.low);
  for (const int order : drawn_engine_orders(study)) {
    const double at_right = order * axis.high / seconds_per_minute;
    if (at_right <= frequency_max) {
      out << "set label 'EO " << order << "' at first " << axis.high << ", first " << at_right
          << " left offset 0.6,0 font ',11' textcolor rgb '#333333'\n";
    } else if (const double at_top = frequency_max * seconds_per_minute / order;
               at_top > axis.low && at_top < free_below) {
      free_below = at_top - label_width * (axis.high - axis.low);
      out << "set label 'EO " << order << "' at first " << at_top << ", first " << frequency_max
          << " center offset 0,0.6 font ',11' textcolor rgb '#333333'\n";
    }
  }
  return out.str();
}

int drawn_families(const Study& study, int nodal_diameter) {
  return std::min(study.parameters.families, study.curves.families(nodal_diameter));
}

Eigen::MatrixXd modal_lines(const Study& study, int nodal_diameter, const SpeedAxis& axis) {
  const int families = drawn_families(study, nodal_diameter);
  Eigen::MatrixXd rows(modal_line_points, 1 + families);
  rows.col(0) = Eigen::VectorXd::LinSpaced(modal_line_points, axis.low, axis.high);
  for (int i = 0; i < modal_line_points; ++i)
    for (int family = 0; family < families; ++family)
      rows(i, 1 + family) = study.curves.frequency(nodal_diameter, family, rows(i, 0) / rpm_per_rad_s);
  return rows;
}

std::string signed_name(int nodal_diameter) {
  if (nodal_diameter == 0) return "0";
  return (nodal_diameter > 0 ? "+" : "\xE2\x88\x92") + std::to_string(std::abs(nodal_diameter));
}

}  // namespace tiprub::style
