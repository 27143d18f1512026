// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <sstream>

#include "postprocess/waves/harmonic_tracking.h"
#include "postprocess/figures/figure.h"
#include "postprocess/figures/figure_style.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

struct Panel {
  std::string title;
  HarmonicTracking tracking;
  std::vector<std::string> names;  ///< of the curves
};

Figure tracking_figure(const Study& study, const std::string& name, const std::vector<Panel>& panels) {
  const style::SpeedAxis axis = style::speed_axis(study);
  const Eigen::VectorXd rpm = style::speeds_rpm(study);
  const double left = 0.1, right = 0.86, low = 0.0, top = 0.96;
  const int count = static_cast<int>(panels.size());
  Figure figure;
  figure.drawing = {name, 1000, 90 + 270 * count, ""};
  figure.data = {{"followed", "speed [rpm]", "curve", "amplitude [mm]"}, {}};
  const double foot = 30.0 / figure.drawing.height, height = (top - foot - low) / count;
  std::ostringstream out;
  out << style::base() << style::range("x", axis.low, axis.high)
      << "set multiplot\nset yrange [0:*]\nset offsets 0,0,graph 0.08,0\n"
      << "set lmargin at screen " << left << "\nset rmargin at screen " << right << "\nset ylabel 'amplitude [mm]'\n";
  for (int p = 0; p < count; ++p) {
    const Panel& panel = panels[static_cast<std::size_t>(p)];
    const Eigen::Index curves = panel.tracking.curves.cols();
    Eigen::MatrixXd rows(rpm.size(), 2 + curves);
    rows << rpm, panel.tracking.mean * mm_per_m, panel.tracking.curves * mm_per_m;
    const double ceiling = top - p * height;
    out << style::block("p" + std::to_string(p), rows) << "set tmargin at screen " << ceiling - 0.02
        << "\nset bmargin at screen " << ceiling - 0.82 * height << "\nset title '" << panel.title
        << "' offset 0,-0.6\n"
        << "set key at screen " << right + 0.01 << "," << ceiling - 0.02 << " left top Left reverse\n"
        << (p + 1 == count ? "set xlabel 'speed [rpm]'\n" : "");
    for (Eigen::Index k = 0; k < curves; ++k) {
      out << (k == 0 ? "plot " : ", ") << "$p" << p << " using 1:" << k + 3 << " with lines linewidth 1.6"
          << " linecolor rgb '" << style::colour(static_cast<int>(k)) << "' title '"
          << panel.names[static_cast<std::size_t>(k)] << "'";
      for (Eigen::Index i = 0; i < rpm.size(); ++i)
        figure.data.rows.push_back({panel.title, rpm[i], panel.names[static_cast<std::size_t>(k)], rows(i, k + 2)});
    }
    out << ", $p" << p << " using 1:2 with lines linewidth 1 dashtype 3 linecolor rgb '#777777' title 'mean'\n";
    for (Eigen::Index i = 0; i < rpm.size(); ++i)
      figure.data.rows.push_back({panel.title, rpm[i], "mean", rows(i, 1)});
  }
  out << "unset multiplot\n";
  figure.drawing.commands = out.str();
  return figure;
}

}  // namespace

Figure nodal_diameter_tracking_figure(const Study& study) {
  constexpr int followed = 3;
  const int lobes = std::max(study.response.scene.lobes, 1);
  std::vector<Panel> panels;
  for (int k = 1; k <= followed && (k == 1 || k * lobes <= study.parameters.engine_order_max); ++k) {
    Panel panel{"EO " + std::to_string(k * lobes), nodal_diameter_tracking(study.map, k * lobes), {}};
    for (Eigen::Index n = 0; n < panel.tracking.curves.cols(); ++n) panel.names.push_back("ND " + std::to_string(n));
    panels.push_back(std::move(panel));
  }
  Figure figure = tracking_figure(study, "nodal_diameter_tracking", panels);
  figure.title = "Nodal-diameter tracking";
  figure.caption =
      "Amplitudes of the nodal diameters at the casing's first engine orders, both directions added; dotted: "
      "their mean.";
  return figure;
}

Figure engine_order_tracking_figure(const Study& study) {
  constexpr int followed = 2, averaged = 6;
  const Eigen::VectorXd shares = energy_shares(study.map);
  std::vector<int> order(static_cast<std::size_t>(shares.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return shares[a] > shares[b]; });
  std::vector<int> engine_orders(averaged);
  std::iota(engine_orders.begin(), engine_orders.end(), 1);
  std::vector<Panel> panels;
  for (std::size_t k = 0; k < std::min<std::size_t>(followed, order.size()); ++k) {
    Panel panel{
        "nodal diameter " + std::to_string(order[k]), engine_order_tracking(study.map, order[k], engine_orders), {}};
    for (const int engine_order : engine_orders) panel.names.push_back("EO " + std::to_string(engine_order));
    panels.push_back(std::move(panel));
  }
  Figure figure = tracking_figure(study, "engine_order_tracking", panels);
  figure.title = "Engine-order tracking";
  figure.caption =
      "Amplitudes of the engine orders 1 to 6 on the two nodal diameters with the most motion; dotted: "
      "their mean.";
  return figure;
}

}  // namespace tiprub
