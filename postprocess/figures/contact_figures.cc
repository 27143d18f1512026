// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "postprocess/figures/figure.h"
#include "postprocess/figures/figure_style.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double degrees = 360.0;

Table contact_table(const Study& study, const ContactMap& map) {
  Table table{{"speed [rpm]", "contrast [1]", "clusters"}, {}};
  for (Eigen::Index area = 0; area < map.share.rows(); ++area)
    table.header.push_back(
        "share at " + fixed(degrees * (static_cast<double>(area) + 0.5) / static_cast<double>(map.share.rows()), 1) +
        " deg [1]");
  const Eigen::VectorXd rpm = style::speeds_rpm(study);
  for (Eigen::Index i = 0; i < rpm.size(); ++i) {
    std::vector<Cell> row = {rpm[i], map.contrast[i], map.clusters[i]};
    for (Eigen::Index area = 0; area < map.share.rows(); ++area) row.emplace_back(map.share(area, i));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Each area is several pixels high, so that a viewer that smooths the picture keeps the areas' edges.
Eigen::MatrixXf contact_pixels(const Study& study, const ContactMap& map, int columns) {
  constexpr int pixels_per_area = 4;
  const Eigen::VectorXi nearest = style::nearest_speeds(study, columns);
  Eigen::MatrixXf pixels = Eigen::MatrixXf::Constant(pixels_per_area * map.share.rows(), columns, std::nanf(""));
  for (int x = 0; x < columns; ++x)
    if (nearest[x] >= 0)
      for (Eigen::Index y = 0; y < pixels.rows(); ++y)
        pixels(y, x) = static_cast<float>(map.share(y / pixels_per_area, nearest[x]));
  return pixels;
}

/// How far the casing is from a node of the undeformed rotor, around the casing [mm].
Eigen::VectorXd gap(const SimulatedScene& scene, Eigen::Index node) {
  return ((scene.clearance[node] - scene.casing_distortion.array()) * mm_per_m).matrix();
}

constexpr double microseconds = 1e6;

/// The drift's line on each lobe, in degrees over rpm; wrapped, so that a line that leaves at the top comes in below.
std::string drift_terms(const Study& study, const ContactDrift& drift) {
  if (!(drift.determination > 0)) return "";
  const double to_degrees = degrees / (2 * std::numbers::pi);
  const int lobes = std::max(study.response.scene.lobes, 1);
  std::ostringstream out;
  out.precision(12);
  for (int lobe = 0; lobe < lobes; ++lobe) {
    const double start = drift.intercept * to_degrees + degrees * lobe / lobes;
    out << ", (" << start << "+" << drift.slope * to_degrees / rpm_per_rad_s << "*x)-360*floor((" << start << "+"
        << drift.slope * to_degrees / rpm_per_rad_s
        << "*x)/360) with points pointtype 7 pointsize 0.22 linecolor rgb '#d62728'";
  }
  return out.str();
}

}  // namespace

Figure contact_map_figure(const Study& study, TipEdge edge) {
  constexpr int columns = 700;
  const ContactMap& map = edge == TipEdge::leading ? study.leading_edge : study.trailing_edge;
  const style::SpeedAxis axis = style::speed_axis(study);
  Figure figure;
  const std::string where = edge == TipEdge::leading ? "leading" : "trailing";
  figure.drawing = {"contact_map_" + where + "_edge", 1000, 560, ""};
  figure.title = "Contact map, " + where + " edge";
  figure.caption = "Where the " + where + " edge of sector 0 rubs: the casing in " +
                   std::to_string(map.share.rows()) +
                   " areas, each coloured by the share of the steps over it that "
                   "are in contact, from white (never) to dark blue (always). Below: contrast, near 1 where the "
                   "contact keeps to few places, and the number of separate places. Grey: speeds without a response.";
  figure.data = contact_table(study, map);
  figure.pixels.push_back({figure.drawing.name + ".pixels", contact_pixels(study, map, columns)});
  const double dx = (axis.high - axis.low) / columns,
               dy = degrees / static_cast<double>(figure.pixels.back().values.rows());
  const Eigen::VectorXd rpm = style::speeds_rpm(study);
  const ContactDrift drift = edge == TipEdge::leading ? study.leading_drift : ContactDrift{};  // as in the paper
  if (drift.determination > 0)
    figure.caption +=
        " Red: the line through the middle of the contact, folded onto one lobe: " +
        fixed(microseconds * drift.slope, 1) + " \xC2\xB5s (R\xC2\xB2 = " + fixed(drift.determination, 3) +
        "); a wave that takes so long along the tip would run at " + fixed(drift.implied_wave_speed, 0) + " m/s.";
  Eigen::MatrixXd below(rpm.size(), 3);
  below << rpm, map.contrast, map.clusters.cast<double>();
  std::ostringstream out;
  out.precision(12);
  out << style::base() << style::contact_palette() << style::missing_background() << style::block("below", below)
      << style::range("x", axis.low, axis.high)
      << "set multiplot\nunset grid\nset lmargin at screen 0.085\nset rmargin at screen 0.86\n"
      << "set tmargin at screen 0.97\nset bmargin at screen 0.33\nset yrange [0:360]\nset ytics 45\n"
      << "set format x ''\nset cbrange [0:1]\nset ylabel 'angle on the casing [deg]'\n"
      << "set cblabel 'share of steps in contact [1]'\n"
      << "set colorbox user origin screen 0.885,0.33 size screen 0.022,0.64\nplot '" << figure.pixels.back().file
      << "' binary array=(" << columns << "," << figure.pixels.back().values.rows() << ") format='%float32' origin=("
      << axis.low + dx / 2 << "," << dy / 2 << ") dx=" << dx << " dy=" << dy << " with image"
      << drift_terms(study, drift) << "\n"
      << "unset object 99\nset grid\nset tmargin at screen 0.30\nset bmargin at screen 0.12\nset format x '%g'\nset "
         "xlabel 'speed "
         "[rpm]'\n"
      << "set yrange [0:1.05]\nset ytics 0.5\nset ylabel 'contrast [1]'\n"
      << style::range("y2", 0, std::max(1.0, 1.1 * map.clusters.maxCoeff())) << "set y2tics "
      << std::max(1, (map.clusters.maxCoeff() + 3) / 4) << " nomirror\nset y2label 'places'\n"
      << "set key at screen 0.85,0.315 right center horizontal\n"
      << "plot $below using 1:2 with linespoints pointtype 7 pointsize 0.35 linewidth 1.2 linecolor rgb '#0072b2' "
         "title 'contrast', '' using 1:3 axes x1y2 with steps linewidth 1.2 linecolor rgb '#d55e00' title 'places'\n"
      << "unset multiplot\n";
  figure.drawing.commands = out.str();
  return figure;
}

Figure casing_figure(const Study& study) {
  constexpr double drawn_distortion = 0.2;  // of the circle's radius, in the picture of the shape
  const SimulatedScene& scene = study.response.scene;
  const Eigen::Index last = scene.clearance.size() - 1;
  const double largest = std::max(scene.casing_distortion.cwiseAbs().maxCoeff(), 1e-12);
  Eigen::MatrixXd rows(scene.casing_angle.size(), 5);
  rows.col(0) = scene.casing_angle * degrees / (2 * std::numbers::pi);
  rows.col(1) = gap(scene, 0);
  rows.col(2) = gap(scene, last);
  const Eigen::ArrayXd radius = 1 - drawn_distortion * scene.casing_distortion.array() / largest;
  rows.col(3) = radius * scene.casing_angle.array().cos();
  rows.col(4) = radius * scene.casing_angle.array().sin();
  Figure figure;
  figure.drawing = {"casing", 1000, 430, ""};
  figure.title = "Casing";
  figure.caption = "Left: the shape, its largest distortion of " + fixed(largest * mm_per_m, 3) +
                   " mm drawn as a fifth of the radius; dashed: the round casing. Right: the gap between the casing "
                   "and the undeformed tip, " +
                   scene.clearance_state + "; below zero the blade has to bend.";
  figure.data = {{"angle [deg]", "gap at leading edge [mm]", "gap at trailing edge [mm]", "distortion [mm]"}, {}};
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    figure.data.rows.push_back({rows(i, 0), rows(i, 1), rows(i, 2), scene.casing_distortion[i] * mm_per_m});
  std::ostringstream out;
  out << style::base() << style::block("casing", rows)
      << "set multiplot\nset parametric\nset trange [0:2*pi]\nset size ratio -1\nset lmargin at screen 0.02\n"
      << "set rmargin at screen 0.34\nset tmargin at screen 0.95\nset bmargin at screen 0.05\nunset tics\n"
      << "unset border\nunset grid\nset xrange [-1.3:1.3]\nset yrange [-1.3:1.3]\n"
      << "set label 1 'rotation' at 0,0 center textcolor rgb '#555555'\n"
      << "set arrow 1 from 0.45*cos(2.6),0.45*sin(2.6) to 0.45*cos(2.75),0.45*sin(2.75) head size 0.09,25 filled "
         "linecolor rgb '#555555'\nset samples 200\n"
      << "plot cos(t), sin(t) with lines dashtype 2 linecolor rgb '#999999', "
      << "0.45*cos(0.4+0.35*t), 0.45*sin(0.4+0.35*t) with lines linecolor rgb '#555555', "
      << "$casing using 4:5 with lines linewidth 2.5 linecolor rgb '#08306b'\n"
      << "unset label 1\nunset arrow 1\nunset parametric\nset size noratio\n"
      << style::base()
      << "set lmargin at screen 0.44\nset rmargin at screen 0.97\nset tmargin at screen 0.86\nset bmargin at screen "
         "0.15\n"
      << "set xrange [0:360]\nset autoscale y\nset offsets 0,0,graph 0.08,graph 0.08\nset xtics nomirror 45\nset "
         "ytics nomirror\n"
      << "set xlabel 'angle on the casing [deg]'\nset ylabel 'gap [mm]'\nset key above horizontal center\n"
      << "set xzeroaxis linewidth 1 linecolor rgb '#777777'\n"
      << "plot $casing using 1:2 with lines linewidth 2 linecolor rgb '#0072b2' title 'leading edge', "
      << "'' using 1:3 with lines linewidth 2 linecolor rgb '#d55e00' title 'trailing edge'\nunset multiplot\n";
  figure.drawing.commands = out.str();
  return figure;
}

Figure contact_force_figure(const Study& study) {
  const SpeedResponse& at = study.shown_response();
  const SimulatedScene& scene = study.response.scene;
  const int last = study.model.contact.size() - 1;
  const Eigen::VectorXd leading = tip_force(at, scene, 0).col(0), trailing = tip_force(at, scene, last).col(0);
  const int samples = at.samples_per_revolution;
  Eigen::MatrixXd trace(samples, 3);
  for (int s = 0; s < samples; ++s) trace.row(s) << degrees * s / samples, leading[s], trailing[s];
  const Eigen::VectorXd leading_lines = line_spectrum(leading), trailing_lines = line_spectrum(trailing);
  const int lines = std::min(static_cast<int>(leading_lines.size()) - 1,
                             study.parameters.engine_order_max * at.recorded_revolutions);
  Eigen::MatrixXd spectrum(lines + 1, 3);
  for (int m = 0; m <= lines; ++m)
    spectrum.row(m) << static_cast<double>(m) / at.recorded_revolutions, leading_lines[m], trailing_lines[m];
  Figure figure;
  figure.drawing = {"contact_force", 1000, 520, ""};
  figure.title = "Contact force";
  figure.caption =
      "Sector 0 at " + fixed(at.speed * rpm_per_rad_s, 0) +
      " rpm, the first recorded revolution (above), "
      "and the spectrum over all recorded ones (below). The force acts along the normal, from the casing "
      "on the blade.";
  figure.data = {{"rotor angle [deg]", "leading edge [N]", "trailing edge [N]"}, {}};
  for (int s = 0; s < samples; ++s) figure.data.rows.push_back({trace(s, 0), trace(s, 1), trace(s, 2)});
  std::ostringstream out;
  out << style::base() << style::block("trace", trace) << style::block("lines", spectrum)
      << "set multiplot\nset lmargin at screen 0.085\nset rmargin at screen 0.97\nset tmargin at screen 0.92\n"
      << "set bmargin at screen 0.58\nset xrange [0:360]\nset xtics 45\nset yrange [0:*]\n"
      << "set xlabel 'rotor angle [deg]'\nset ylabel 'force [N]'\nset key at screen 0.97,0.96 right center "
         "horizontal\n"
      << "plot $trace using 1:2 with lines linewidth 1.5 linecolor rgb '#0072b2' title 'leading edge', "
      << "'' using 1:3 with lines linewidth 1.5 linecolor rgb '#d55e00' title 'trailing edge'\n"
      << "set tmargin at screen 0.44\nset bmargin at screen 0.12\nset xlabel 'engine order'\nset ylabel 'amplitude "
         "[N]'\n"
      << style::range("x", -0.5, study.parameters.engine_order_max + 0.5)
      << "set xtics 2\nunset key\nplot $lines using ($1-0.06):2 with impulses linewidth 3 linecolor rgb '#0072b2', "
      << "'' using ($1+0.06):3 with impulses linewidth 3 linecolor rgb '#d55e00'\nunset multiplot\n";
  figure.drawing.commands = out.str();
  return figure;
}

}  // namespace tiprub
