// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "postprocess/figures/figure.h"
#include "postprocess/figures/figure_style.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double seconds_per_minute = 60;
constexpr double headroom = 1.12;  // of the highest drawn frequency

double highest_frequency(const Study& study, double speed) {
  double highest = 0;
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    for (int family = 0; family < style::drawn_families(study, n); ++family)
      highest = std::max(highest, study.curves.frequency(n, family, speed));
  return highest;
}

/// The paper's fig. 4 has five.
int veering_families(const Study& study) {
  constexpr int fewest = 5;
  return std::max(fewest, study.parameters.families);
}

int veering_families(const Study& study, int nodal_diameter) {
  return std::min(veering_families(study), study.curves.families(nodal_diameter));
}

/// Nodal diameter, then the first families [Hz] at a speed; a missing family is NaN.
Eigen::MatrixXd veering_rows(const Study& study, double speed) {
  const int count = study.model.nodal_diameter_max() + 1, families = veering_families(study);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(count, 1 + families, std::nan(""));
  for (int n = 0; n < count; ++n) {
    rows(n, 0) = n;
    for (int family = 0; family < veering_families(study, n); ++family)
      rows(n, 1 + family) = study.curves.frequency(n, family, speed);
  }
  return rows;
}

/// Engine orders 1 .. that stay below a frequency: nodal diameter, frequency [Hz], engine order, driven by the
/// casing.
Eigen::MatrixXd zigzag_rows(const Study& study, double speed, double frequency_max) {
  const double revolutions_per_second = speed * hz_per_rad_s;
  const int last = std::max(1, static_cast<int>(frequency_max / revolutions_per_second));
  const int lobes = study.response.scene.lobes;
  Eigen::MatrixXd rows(last + 1, 4);
  for (int order = 0; order <= last; ++order)
    rows.row(order) << aliased_nodal_diameter(order, study.model.sector_count), order * revolutions_per_second, order,
        order > 0 && lobes > 0 && order % lobes == 0 ? 1 : 0;
  return rows;
}

/// Beside the last nodal diameter, at a speed.
std::string family_labels(const Study& study, double speed) {
  const int last = study.model.nodal_diameter_max();
  std::ostringstream out;
  for (int family = 0; family < veering_families(study, last); ++family)
    out << "set label " << 1 + family << " 'family " << 1 + family << "' at " << last << ","
        << study.curves.frequency(last, family, speed) << " left offset 0.9,0 font ',10' textcolor rgb '#0072b2'\n";
  return out.str();
}

std::string interference_panel(const Study& study, const std::string& suffix, double speed, double frequency_max) {
  constexpr int few_orders = 12;  // more, and only those that the casing drives are named
  const Eigen::MatrixXd zigzag = zigzag_rows(study, speed, frequency_max);
  const char* named = zigzag.rows() > few_orders + 1 ? "$4>0" : "$3>0";
  std::ostringstream out;
  out << style::block("spin" + suffix, veering_rows(study, speed)) << style::block("zigzag" + suffix, zigzag)
      << family_labels(study, speed) << "set title 'at " << rpm_text(speed) << "' offset 0,-0.5\nplot $zigzag"
      << suffix << " using 1:2 with lines linewidth 1 linecolor rgb '#999999' title 'engine orders'";
  for (int family = 0; family < veering_families(study); ++family)
    out << ", $rest using 1:" << family + 2
        << " with linespoints pointtype 6 pointsize 0.9 dashtype 3 linecolor rgb '"
        << "#0072b2' " << (family == 0 ? "title 'modes at rest'" : "notitle") << ", $spin" << suffix
        << " using 1:" << family + 2
        << " with linespoints pointtype 7 pointsize 0.9 linewidth 1.4 linecolor rgb '#0072b2' "
        << (family == 0 ? "title 'modes at speed'" : "notitle");
  out << ", $zigzag" << suffix
      << " using ($4>0?$1:NaN):2 with points pointtype 7 pointsize 0.8 linecolor rgb '#d55e00' title 'driven by the "
         "casing'";
  // Names beside the line: below it where it rises with the engine order, above it where it falls.
  const int sectors = study.model.sector_count;
  for (const bool rising : {true, false})
    out << ", '' using 1:2:(" << named << " && " << (rising ? "" : "!") << "(2*(int($3)%" << sectors << ")<"
        << sectors << ")?sprintf('EO %d',$3):'') with labels left offset 0.8," << (rising ? -0.3 : 0.4)
        << " font ',10' textcolor rgb '#555555' notitle";
  out << "\n";
  return out.str();
}

/// The lowest critical speed, where the zig-zag has its many legs; the highest speed if there is none other.
double second_speed(const Study& study, double shown) {
  for (const CriticalSpeed& critical : study.critical)
    if (critical.speed != shown) return critical.speed;
  return study.range.high;
}

}  // namespace

Figure campbell_figure(const Study& study) {
  const style::SpeedAxis axis{0, style::speed_axis(study).high};
  const double top = headroom * highest_frequency(study, study.range.high);
  const int count = study.model.nodal_diameter_max() + 1;
  Figure figure;
  figure.drawing = {"campbell", 1000, 640, ""};
  figure.title = "Campbell diagram";
  figure.caption =
      "Natural frequencies in the rotor frame over speed, the first families by nodal diameter, and "
      "engine-order lines. Shaded: the simulated speeds. Circles: crossings that the linear rule with "
      "aliasing lists (f = k \xC3\x97 lobes \xC3\x97 \xCE\xA9 on the nodal diameter of eq. 17); squares: those of "
      "eq. 2.";
  figure.data = {{"speed [rpm]", "nodal diameter", "family", "frequency [Hz]"}, {}};
  std::ostringstream out, plot;
  out << style::base() << style::range("x", axis.low, axis.high) << style::range("y", 0, top)
      << "set lmargin at screen 0.085\nset rmargin at screen 0.91\nset tmargin at screen 0.86\n"
      << "set bmargin at screen 0.11\nset xlabel 'speed [rpm]'\nset ylabel 'frequency in the rotor frame [Hz]'\n"
      << "set key at screen 0.5,0.985 center top horizontal maxrows 2 font ',11'\n"
      << "set object 1 rectangle from " << study.range.low * rpm_per_rad_s << ",0 to "
      << study.range.high * rpm_per_rad_s << "," << top
      << " fillcolor rgb '#eef3f8' fillstyle solid noborder behind\n"
      << style::engine_order_labels(study, axis, top);
  for (const int order : style::drawn_engine_orders(study))
    plot << (plot.str().empty() ? "plot " : ", ") << order
         << "*x/60 with lines linewidth 0.6 linecolor rgb '#aaaaaa'";
  for (int n = 0; n < count; ++n) {
    const Eigen::MatrixXd rows = style::modal_lines(study, n, axis);
    out << style::block("modes" + std::to_string(n), rows);
    for (Eigen::Index family = 1; family < rows.cols(); ++family) {
      plot << ", $modes" << n << " using 1:" << family + 1 << " with lines linewidth 1.4 linecolor rgb '"
           << style::colour(n) << "' " << (family == 1 ? "title 'ND " + std::to_string(n) + "'" : "notitle");
      for (Eigen::Index i = 0; i < rows.rows(); ++i)
        figure.data.rows.push_back({rows(i, 0), n, static_cast<int>(family), rows(i, family)});
    }
  }
  const auto points = [&](const std::string& name, const std::vector<Crossing>& crossings, const std::string& look) {
    if (crossings.empty()) return;
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(crossings.size()), 2);
    for (std::size_t i = 0; i < crossings.size(); ++i)
      rows.row(static_cast<Eigen::Index>(i)) << crossings[i].speed * rpm_per_rad_s, crossings[i].frequency;
    out << style::block(name, rows);
    plot << ", $" << name << " with points linecolor rgb '#222222' linewidth 1.2 " << look;
  };
  points("aliased", study.aliased, "pointtype 6 pointsize 1.1 title 'rule with aliasing'");
  points("linear", study.equation_2, "pointtype 4 pointsize 1.5 title 'eq. 2'");
  figure.drawing.commands = out.str() + plot.str() + "\n";
  return figure;
}

Figure interference_figure(const Study& study) {
  const double shown = study.shown_response().speed, second = second_speed(study, shown);
  double top = 0;
  for (const double speed : {0.0, shown, second}) {
    const Eigen::MatrixXd rows = veering_rows(study, speed);
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      for (Eigen::Index family = 1; family < rows.cols(); ++family)
        if (std::isfinite(rows(i, family))) top = std::max(top, headroom * rows(i, family));
  }
  const int count = study.model.nodal_diameter_max() + 1;
  Figure figure;
  figure.drawing = {"interference", 1050, 580, ""};
  figure.title = "Nodal diameter over frequency";
  figure.caption =
      "The families over the nodal diameter, at rest and at two speeds: the one whose motion is shown below, and the "
      "lowest critical speed. The zig-zag is where the sectors see the engine orders (eq. 17); a resonance threatens "
      "where one of "
      "its orange corners, the multiples of the lobes, lies on a mode.";
  figure.data = {{"speed [rpm]", "nodal diameter"}, {}};
  for (int family = 1; family <= veering_families(study); ++family)
    figure.data.header.push_back("family " + std::to_string(family) + " [Hz]");
  for (const double speed : {0.0, shown, second}) {
    const Eigen::MatrixXd rows = veering_rows(study, speed);
    for (Eigen::Index n = 0; n < rows.rows(); ++n) {
      figure.data.rows.push_back({speed * rpm_per_rad_s, static_cast<int>(n)});
      for (Eigen::Index k = 1; k < rows.cols(); ++k) figure.data.rows.back().emplace_back(rows(n, k));
    }
  }
  std::ostringstream out;
  out << style::base() << style::block("rest", veering_rows(study, 0.0))
      << "set multiplot layout 1,2 margins screen 0.085,0.98,0.11,0.86 spacing screen 0.07,0.1\n"
      << style::range("x", -0.3, count - 0.1) << style::range("y", 0, top)
      << "set xtics 1\nset xlabel 'nodal diameter'\nset ylabel 'frequency in the rotor frame [Hz]'\n"
      << "set key at screen 0.53,0.985 center top horizontal maxrows 1\n"
      << interference_panel(study, "1", shown, top) << "unset ylabel\nunset key\n"
      << interference_panel(study, "2", second, top) << "unset multiplot\n";
  figure.drawing.commands = out.str();
  return figure;
}

}  // namespace tiprub
