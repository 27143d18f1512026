// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <sstream>

#include "postprocess/figures/figure.h"
#include "postprocess/figures/figure_style.h"
#include "postprocess/tables/units.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub {

namespace {

/// Bars over 0 .. values - 1 at a panel between two screen positions.
std::string bar_panel(const std::string& name, const Eigen::VectorXd& backward, const Eigen::VectorXd& forward,
                      const std::string& title, const std::string& axis, double left, double right) {
  Eigen::MatrixXd rows(backward.size(), 3);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) rows.row(i) << static_cast<double>(i), backward[i], forward[i];
  std::ostringstream out;
  out << style::block(name, rows) << "set lmargin at screen " << left << "\nset rmargin at screen " << right
      << "\nset title '" << title << "' offset 0,-0.5\nset xlabel '" << axis << "'\n"
      << style::range("x", -0.7, static_cast<double>(rows.rows()) - 0.3) << "plot $" << name
      << " using 1:($2+$3) with boxes fillcolor rgb '#d55e00' title 'forward', '' using 1:2 with boxes fillcolor rgb "
         "'#0072b2' title 'backward or standing'\n";
  return out.str();
}

}  // namespace

Figure harmonic_bars_figure(const Study& study) {
  const TravellingSpectrum& spectrum = study.map.columns[static_cast<std::size_t>(study.shown)].spectrum;
  const int sectors = spectrum.sector_count, half = sectors / 2;
  // The casing's second harmonic and its nodal diameter: with two lobes on ten sectors the paper's EO 4 and nodal
  // diameter 4.
  const int order = 2 * std::max(study.response.scene.lobes, 1);
  const int diameter = aliased_nodal_diameter(order, sectors);
  const auto amplitude = [&](int engine_order, int n) { return spectrum.at(engine_order, n) * mm_per_m; };
  Eigen::VectorXd backward(half + 1), forward(half + 1);
  for (int n = 0; n <= half; ++n) {
    backward[n] = amplitude(order, n);
    forward[n] = is_standing(n, sectors) ? 0 : amplitude(order, -n);
  }
  const int last = study.parameters.engine_order_max;
  Eigen::VectorXd order_backward(last + 1), order_forward(last + 1);
  for (int k = 0; k <= last; ++k) {
    order_backward[k] = k == 0 ? 0 : amplitude(k, diameter);
    order_forward[k] = k == 0 || is_standing(diameter, sectors) ? 0 : amplitude(k, -diameter);
  }
  Figure figure;
  figure.drawing = {"harmonic_bars", 1000, 400, ""};
  figure.title = "Harmonics at one speed";
  figure.caption = "At " + fixed(study.shown_response().speed * rpm_per_rad_s, 0) +
                   " rpm: the nodal diameters on engine order " + std::to_string(order) +
                   ", and the engine orders on nodal diameter " + std::to_string(diameter) +
                   ", both directions one on the other. The trackings follow these bars over speed.";
  figure.data = {{"engine order", "nodal diameter", "backward or standing [mm]", "forward [mm]"}, {}};
  for (int n = 0; n <= half; ++n) figure.data.rows.push_back({order, n, backward[n], forward[n]});
  for (int k = 1; k <= last; ++k) figure.data.rows.push_back({k, diameter, order_backward[k], order_forward[k]});
  std::ostringstream out;
  out << style::base()
      << "set multiplot\nset boxwidth 0.7\nset style fill solid noborder\nset yrange [0:*]\nset xtics 1\n"
      << "set tmargin at screen 0.83\nset bmargin at screen 0.16\nset ylabel 'amplitude [mm]'\n"
      << "set key at screen 0.54,0.95 center center horizontal maxrows 1\n"
      << bar_panel("diameters", backward, forward, "EO " + std::to_string(order), "nodal diameter", 0.105, 0.45)
      << "unset key\n"
      << bar_panel("orders", order_backward, order_forward, "nodal diameter " + std::to_string(diameter),
                   "engine order", 0.57, 0.975)
      << "unset multiplot\n";
  figure.drawing.commands = out.str();
  return figure;
}

}  // namespace tiprub
