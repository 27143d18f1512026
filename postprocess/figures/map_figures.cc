// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "postprocess/figures/figure.h"
#include "postprocess/figures/figure_style.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double line_half_width = 0.1;    // of an engine order: how thick a spectral line is drawn at most
constexpr double above_modes = 2;          // how far a map reaches above the highest drawn mode
constexpr double smallest_colour = 1e-6;   // [mm] of a map without motion
constexpr double seconds_per_minute = 60;  // EO k is the line f = k rpm / 60

struct Scale {
  double low, high;  // [mm]
};

Scale colour_scale(const Study& study) {
  const double given = study.parameters.amplitude_max_mm;
  const double high = given > 0 ? given : std::max(study.map.largest() * mm_per_m, smallest_colour);
  return {high * std::pow(10.0, -study.parameters.amplitude_decades), high};
}

/// [Hz] the highest engine order at the highest speed, but not far above the families that are drawn.
double frequency_max(const Study& study) {
  double modes = 0;
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    modes = std::max(modes, study.curves.frequency(n, style::drawn_families(study, n) - 1, study.range.high));
  const double engine_order = study.parameters.engine_order_max * style::speed_axis(study).high / seconds_per_minute;
  return modes > 0 ? std::min(engine_order, above_modes * modes) : engine_order;
}

/// The line of a spectrum that is drawn at a frequency, or -1 between lines.
int line_at(const TravellingSpectrum& spectrum, double engine_order) {
  const double line = engine_order * spectrum.revolutions;
  const int nearest = static_cast<int>(std::lround(line));
  const double half_width = std::min(0.5, line_half_width * spectrum.revolutions);
  return nearest > 0 && nearest < spectrum.lines() && std::abs(line - nearest) <= half_width ? nearest : -1;
}

/// The total (nodal_diameter < 0) or one part [mm] on a grid; log scales don't know zero: `floor` stands for it.
Eigen::MatrixXf map_pixels(const Study& study, int nodal_diameter, int width, int height, double floor) {
  const Eigen::VectorXi nearest = style::nearest_speeds(study, width);
  const style::SpeedAxis axis = style::speed_axis(study);
  const double top = frequency_max(study);
  Eigen::MatrixXf pixels = Eigen::MatrixXf::Constant(height, width, static_cast<float>(floor));
  for (int x = 0; x < width; ++x) {
    if (nearest[x] < 0) {
      pixels.col(x).setConstant(std::nanf(""));
      continue;
    }
    const MapColumn& column = study.map.columns[static_cast<std::size_t>(nearest[x])];
    const double revolutions_per_second =
        (axis.low + (axis.high - axis.low) * (x + 0.5) / width) / seconds_per_minute;
    for (int y = 0; y < height; ++y) {
      const double frequency = top * (y + 0.5) / height;
      const int line = line_at(column.spectrum, frequency / revolutions_per_second);
      if (line < 0) continue;
      const double amplitude = nodal_diameter < 0 ? column.total[line] : column.parts(line, nodal_diameter);
      pixels(y, x) = static_cast<float>(std::max(amplitude * mm_per_m, floor));
    }
  }
  return pixels;
}

std::string image_term(const Study& study, const Pixels& pixels) {
  const style::SpeedAxis axis = style::speed_axis(study);
  const double dx = (axis.high - axis.low) / static_cast<double>(pixels.values.cols());
  const double dy = frequency_max(study) / static_cast<double>(pixels.values.rows());
  std::ostringstream out;
  out.precision(12);
  out << "'" << pixels.file << "' binary array=(" << pixels.values.cols() << "," << pixels.values.rows()
      << ") format='%float32' origin=(" << axis.low + dx / 2 << "," << dy / 2 << ") dx=" << dx << " dy=" << dy
      << " with image";
  return out.str();
}

std::string engine_order_terms(const Study& study) {
  std::string out;
  for (const int order : style::drawn_engine_orders(study))
    out += ", " + std::to_string(order) + "*x/60 with lines linewidth 0.5 linecolor rgb '#a0ffffff'";
  return out;
}

std::string modal_terms(const Study& study, int nodal_diameter) {
  std::string out;
  for (int family = 0; family < style::drawn_families(study, nodal_diameter); ++family)
    out += ", $modes" + std::to_string(nodal_diameter) + " using 1:" + std::to_string(family + 2) +
           " with lines linewidth 1.1 linecolor rgb '#ff7f50'";
  return out;
}

std::string map_axes(const Study& study, const Scale& scale) {
  const style::SpeedAxis axis = style::speed_axis(study);
  std::ostringstream out;
  out << style::base() << style::amplitude_palette() << style::missing_background() << "unset grid\n"
      << style::range("x", axis.low, axis.high) << style::range("y", 0, frequency_max(study)) << "set logscale cb\n"
      << style::range("cb", scale.low, scale.high) << "set format cb '%g'\n";
  return out.str();
}

Table map_table(const Study& study) {
  Table table{{"speed [rpm]", "frequency [Hz]", "engine order", "total [mm]"}, {}};
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    table.header.push_back("nodal diameter " + std::to_string(n) + " [mm]");
  for (const MapColumn& column : study.map.columns)
    for (int line = 0; line < column.spectrum.lines(); ++line) {
      const double order = column.spectrum.engine_order(line);
      if (order > study.parameters.engine_order_max) break;
      std::vector<Cell> row = {column.speed * rpm_per_rad_s, order * column.speed * hz_per_rad_s, order,
                               column.total[line] * mm_per_m};
      for (Eigen::Index n = 0; n < column.parts.cols(); ++n) row.emplace_back(column.parts(line, n) * mm_per_m);
      table.rows.push_back(std::move(row));
    }
  return table;
}

std::string all_modal_blocks(const Study& study) {
  std::string out;
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    out += style::block("modes" + std::to_string(n), style::modal_lines(study, n, style::speed_axis(study)));
  return out;
}

std::string what_is_drawn(const Study& study) {
  return std::string("Amplitude of the ") + name_of(study.parameters.component) + " at the " +
         name_of(study.parameters.edge) + " (contact node " + std::to_string(study.map_node) +
         "), the sum over the nodal diameters, rotor frame, logarithmic colours.";
}

/// "family 1" over the left end of its line.
std::string family_labels(const Study& study) {
  const style::SpeedAxis axis = style::speed_axis(study);
  const double speed = axis.low / rpm_per_rad_s;
  std::ostringstream out;
  out.precision(8);
  for (int family = 0; family < style::drawn_families(study, 0); ++family)
    if (const double frequency = study.curves.frequency(0, family, speed); frequency < frequency_max(study))
      out << "set label 'family " << family + 1 << "' at first " << axis.low << ", first " << frequency
          << " left offset 0.6,0.5 front font ',10' textcolor rgb '#ffb482'\n";
  return out.str();
}

/// Points at the foot of the map: speeds whose motion the paper's assumptions leave out. Blocks, then terms for
/// `plot`.
struct Marks {
  std::string blocks, terms;
};

Marks unusual_motion(const Study& study) {
  constexpr double foot = 0.018, step = 0.022;  // of the frequency axis
  struct Kind {
    const char *name, *title, *look;
    std::function<bool(const SpeedResponse&)> holds;
  };
  const std::vector<Kind> kinds = {
      {"irregular", "irregular", "pointtype 2 pointsize 0.55 linewidth 1.2 linecolor rgb '#ffffff'",
       [](const SpeedResponse& at) { return at.motion == MotionClass::irregular; }},
      {"subharmonic", "subharmonic", "pointtype 8 pointsize 0.7 linewidth 1.2 linecolor rgb '#ffe680'",
       [](const SpeedResponse& at) { return at.motion == MotionClass::subharmonic; }},
      {"breaking", "breaks the symmetry", "pointtype 6 pointsize 0.65 linewidth 1.2 linecolor rgb '#ff9ecb'",
       [](const SpeedResponse& at) { return at.audit.symmetry == SymmetryVerdict::breaking; }}};
  Marks marks;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    std::vector<double> speeds;
    for (const SpeedResponse& at : study.response.speeds)
      if (kinds[k].holds(at)) speeds.push_back(at.speed * rpm_per_rad_s);
    if (speeds.empty()) continue;
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(speeds.size()), 2);
    rows.col(0) = Eigen::Map<const Eigen::VectorXd>(speeds.data(), rows.rows());
    rows.col(1).setConstant((foot + step * static_cast<double>(k)) * frequency_max(study));
    marks.blocks += style::block(kinds[k].name, rows);
    marks.terms +=
        std::string(", $") + kinds[k].name + " with points " + kinds[k].look + " title '" + kinds[k].title + "'";
  }
  return marks;
}

bool moves(const Study& study, int nodal_diameter) {
  const std::vector<int>& moving = study.response.scene.nodal_diameters;
  return std::find(moving.begin(), moving.end(), nodal_diameter) != moving.end();
}

/// All nodal diameters as in the paper's figure if they are few, else those that move.
std::vector<int> panel_nodal_diameters(const Study& study) {
  constexpr int few = 6, most = 12;
  std::vector<int> panels;
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n)
    if (study.model.nodal_diameter_max() < few || moves(study, n)) panels.push_back(n);
  if (panels.size() > most) panels.resize(most);
  return panels;
}

}  // namespace

Figure interaction_map_figure(const Study& study) {
  constexpr int width = 700, height = 480;
  Figure figure;
  figure.drawing = {"interaction_map", 1000, 640, ""};
  figure.title = "Interaction map";
  figure.caption =
      what_is_drawn(study) +
      " White lines: engine orders f = k\xCE\xA9. Orange lines: natural "
      "frequencies of the first families, all nodal diameters. A ridge glows where an engine order "
      "meets a mode that its nodal diameter can drive. Marks at the foot: speeds whose motion is not the same every "
      "revolution, or at which a nodal diameter that was left out would grow. Grey: speeds without a response.";
  figure.data = map_table(study);
  const Scale scale = colour_scale(study);
  figure.pixels.push_back({"interaction_map.pixels", map_pixels(study, -1, width, height, scale.low)});
  std::ostringstream out;
  const Marks marks = unusual_motion(study);
  out << map_axes(study, scale) << all_modal_blocks(study) << marks.blocks
      << "set key opaque fillcolor rgb '#31688e' textcolor rgb '#ffffff' at graph 0.99, graph 0.1 right bottom "
         "samplen 0.5\n"
      << "set lmargin at screen 0.085\nset rmargin at screen 0.815\nset tmargin at screen 0.94\n"
      << "set bmargin at screen 0.11\nset xlabel 'speed [rpm]'\nset ylabel 'frequency in the rotor frame [Hz]'\n"
      << "set cblabel 'amplitude [mm]'\nset colorbox user origin screen 0.885,0.11 size screen 0.022,0.83\n"
      << style::engine_order_labels(study, style::speed_axis(study), frequency_max(study)) << family_labels(study)
      << "plot " << image_term(study, figure.pixels.back()) << engine_order_terms(study);
  for (int n = 0; n <= study.model.nodal_diameter_max(); ++n) out << modal_terms(study, n);
  out << marks.terms << "\n";
  figure.drawing.commands = out.str();
  return figure;
}

Figure interaction_map_parts_figure(const Study& study) {
  constexpr int width = 330, height = 260, columns = 3;
  const std::vector<int> panels = panel_nodal_diameters(study);
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  Figure figure;
  figure.drawing = {"interaction_map_parts", 1100, 70 + 330 * rows, ""};
  figure.title = "Interaction map by nodal diameter";
  figure.caption =
      "The parts whose sum is the interaction map, on the same colours; forward and backward waves of a "
      "nodal diameter are added. Orange lines: the natural frequencies of that nodal diameter.";
  const Scale scale = colour_scale(study);
  std::ostringstream out;
  out << map_axes(study, scale) << all_modal_blocks(study) << "set multiplot layout " << rows << "," << columns
      << " margins screen 0.07,0.875,0.09,0.95 spacing screen 0.035,0.10\n"
      << "set xtics rotate by 35 right font ',10'\nset ytics font ',10'\nset cblabel 'amplitude [mm]'\n"
      << "set colorbox user origin screen 0.895,0.09 size screen 0.018,0.86\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int n = panels[i];
    figure.pixels.push_back({"part" + std::to_string(n) + ".pixels", map_pixels(study, n, width, height, scale.low)});
    out << "set title 'nodal diameter " << n << (moves(study, n) ? "" : " (at rest)") << "' offset 0,-0.6\n"
        << (i % columns == 0 ? "set ylabel 'frequency [Hz]'\nset format y '%g'\n" : "unset ylabel\nset format y ''\n")
        << (i + columns >= panels.size() ? "set xlabel 'speed [rpm]' offset 0,0.3\n" : "unset xlabel\n") << "plot "
        << image_term(study, figure.pixels.back()) << engine_order_terms(study) << modal_terms(study, n) << "\n"
        << (i == 0 ? "unset colorbox\n" : "");
  }
  out << "unset multiplot\n";
  figure.drawing.commands = out.str();
  figure.data = {{"speed [rpm]", "engine order", "signed nodal diameter", "direction", "amplitude [mm]", "family",
                  "natural frequency [Hz]", "detuning [%]"},
                 {}};
  for (const Ridge& ridge : study.ridges)
    figure.data.rows.push_back({ridge.speed * rpm_per_rad_s, ridge.wave.engine_order,
                                ridge.wave.signed_nodal_diameter, name_of(ridge.wave.direction),
                                ridge.wave.amplitude * mm_per_m, ridge.wave.family + 1, ridge.wave.natural_frequency,
                                100 * ridge.wave.detuning});
  figure.caption += " The table beside it lists the ridges: every wave's peaks over speed.";
  return figure;
}

Figure waterfall_figure(const Study& study) {
  constexpr double tallest = 0.2;  // of the speed axis: height of the largest line
  Figure figure;
  figure.drawing = {"waterfall", 900, 640, ""};
  figure.title = "Waterfall";
  figure.caption =
      "The spectra of the interaction map one above the other, linear in amplitude; the largest line is " +
      fixed(study.map.largest() * mm_per_m, 3) + " mm high.";
  const style::SpeedAxis axis = style::speed_axis(study);
  const double height = tallest * (axis.high - axis.low);
  const double scale = height / std::max(study.map.largest(), smallest_colour / mm_per_m);
  figure.data = {{"speed [rpm]", "frequency [Hz]", "total [mm]"}, {}};
  std::ostringstream out, plot;
  out << style::base() << style::range("x", 0, frequency_max(study))
      << style::range("y", axis.low, axis.high + height)
      << "set xlabel 'frequency in the rotor frame [Hz]'\nset ylabel 'speed [rpm], spectra on top'\n";
  for (std::size_t i = study.map.columns.size(); i-- > 0;) {  // from the back to the front
    const MapColumn& column = study.map.columns[i];
    const double rpm = column.speed * rpm_per_rad_s;
    const int last =
        std::min(column.spectrum.lines() - 1, study.parameters.engine_order_max * column.spectrum.revolutions);
    Eigen::MatrixXd rows(3 * last + 2, 2);
    rows.row(0) << 0, rpm;
    rows.row(3 * last + 1) << frequency_max(study), rpm;
    for (int line = 1; line <= last; ++line) {
      const double order = column.spectrum.engine_order(line), frequency = order * column.speed * hz_per_rad_s;
      const double half = std::min(0.5 / column.spectrum.revolutions, line_half_width) * column.speed * hz_per_rad_s;
      rows.row(3 * line - 2) << frequency - half, rpm;
      rows.row(3 * line - 1) << frequency, rpm + scale * column.total[line];
      rows.row(3 * line) << frequency + half, rpm;
      figure.data.rows.push_back({rpm, frequency, column.total[line] * mm_per_m});
    }
    const std::string name = "s" + std::to_string(i);
    out << style::block(name, rows);
    plot << (plot.str().empty() ? "plot " : ", ") << "$" << name << " with filledcurves y=" << rpm
         << " linecolor rgb '#ffffff', $" << name << " with lines linewidth 0.8 linecolor rgb '#31688e'";
  }
  out << plot.str() << "\n";
  figure.drawing.commands = out.str();
  return figure;
}

}  // namespace tiprub
