// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"
#include "postprocess/waves/harmonic_tracking.h"

namespace tiprub {

namespace {

/// What one panel follows over speed.
struct Panel {
  std::string title;
  HarmonicTracking tracking;
};

/// "EO 1", "EO 2", ..
std::vector<std::string> numbered(const std::string& word, int first, Eigen::Index count) {
  std::vector<std::string> names;
  for (int i = first; i < first + static_cast<int>(count); ++i) names.push_back(word + " " + std::to_string(i));
  return names;
}

void append(Table& table, const Panel& panel, const std::string& curve, const Eigen::VectorXd& rpm,
            const Eigen::VectorXd& amplitude) {
  for (Eigen::Index i = 0; i < rpm.size(); ++i)
    table.rows.push_back({panel.title, rpm[i], curve, amplitude[i] * mm_per_m});
}

/// `names` are the curves', the same in each panel.
Drawing tracking_drawing(const Study& study, const std::string& name, const std::vector<Panel>& panels,
                         const std::vector<std::string>& names) {
  const int count = static_cast<int>(panels.size());
  ScriptTable curves{"curves", {}};
  std::vector<std::string> titles;
  for (const Panel& panel : panels) {
    Eigen::MatrixXd rows(panel.tracking.mean.size(), 2 + panel.tracking.curves.cols());
    rows << speeds_rpm(study), panel.tracking.mean * mm_per_m, panel.tracking.curves * mm_per_m;
    curves.sheets.push_back(rows);
    titles.push_back(panel.title);
  }
  Drawing drawing{.name = name,
                  .width = 1000,
                  .height = 90 + 270 * count,
                  .script = "tracking",
                  .values = {{"panels", count},
                             {"panel_title", titles},
                             {"curves", static_cast<int>(names.size())},
                             {"curve_name", names}},
                  .tables = {curves}};
  set_speed_axis(drawing, speed_axis(study));
  return drawing;
}

Table tracking_table(const Study& study, const std::vector<Panel>& panels, const std::vector<std::string>& names) {
  const Eigen::VectorXd rpm = speeds_rpm(study);
  Table table{{"followed", "speed [rpm]", "curve", "amplitude [mm]"}, {}};
  for (const Panel& panel : panels) {
    for (std::size_t k = 0; k < names.size(); ++k)
      append(table, panel, names[k], rpm, panel.tracking.curves.col(static_cast<Eigen::Index>(k)));
    append(table, panel, "mean", rpm, panel.tracking.mean);
  }
  return table;
}

/// The nodal diameters, the one with the most motion first.
std::vector<int> by_energy(const Study& study) {
  const Eigen::VectorXd shares = energy_shares(study.map);
  std::vector<int> order(static_cast<std::size_t>(shares.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return shares[a] > shares[b]; });
  return order;
}

}  // namespace

Figure nodal_diameter_tracking_figure(const Study& study) {
  constexpr int followed = 3;
  const int lobes = std::max(study.response.scene.lobes, 1);
  std::vector<Panel> panels;
  for (int k = 1; k <= followed && (k == 1 || k * lobes <= study.parameters.engine_order_max); ++k)
    panels.push_back({"EO " + std::to_string(k * lobes), nodal_diameter_tracking(study.map, k * lobes)});
  const std::vector<std::string> names = numbered("ND", 0, panels.front().tracking.curves.cols());
  return {.drawing = tracking_drawing(study, "nodal_diameter_tracking", panels, names),
          .title = "Nodal-diameter tracking",
          .caption =
              "Amplitudes of the nodal diameters at the casing's first engine orders, both directions added; "
              "dotted: their mean.",
          .data = tracking_table(study, panels, names)};
}

Figure engine_order_tracking_figure(const Study& study) {
  constexpr std::size_t followed = 2, averaged = 6;
  std::vector<int> engine_orders(averaged);
  std::iota(engine_orders.begin(), engine_orders.end(), 1);
  std::vector<Panel> panels;
  const std::vector<int> nodal_diameters = by_energy(study);
  for (std::size_t k = 0; k < std::min(followed, nodal_diameters.size()); ++k)
    panels.push_back({"nodal diameter " + std::to_string(nodal_diameters[k]),
                      engine_order_tracking(study.map, nodal_diameters[k], engine_orders)});
  const std::vector<std::string> names = numbered("EO", 1, averaged);
  return {.drawing = tracking_drawing(study, "engine_order_tracking", panels, names),
          .title = "Engine-order tracking",
          .caption =
              "Amplitudes of the engine orders 1 to 6 on the two nodal diameters with the most motion; dotted: "
              "their mean.",
          .data = tracking_table(study, panels, names)};
}

}  // namespace tiprub
