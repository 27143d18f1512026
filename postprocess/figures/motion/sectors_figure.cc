// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "postprocess/figures/motion/sector_signals.h"
#include "postprocess/figures/study_figures.h"

namespace tiprub {

namespace {

/// One period of the motion is drawn, or all that is recorded if there is none.
int drawn_revolutions(const SpeedResponse& response) {
  const int period = response.period_revolutions;
  return std::clamp(period == 0 ? response.recorded_revolutions : period, 1, response.recorded_revolutions);
}

Table signal_table(const SectorSignal& signal, Eigen::Index samples, int samples_per_revolution) {
  Table table{{"rotor angle [deg]"}, {}};
  for (Eigen::Index j = 0; j < signal.values.cols(); ++j)
    table.header.push_back("sector " + std::to_string(j) + " [" + signal.unit + "]");
  for (Eigen::Index s = 0; s < samples; ++s) {
    table.rows.push_back({360.0 * static_cast<double>(s) / samples_per_revolution});
    for (Eigen::Index j = 0; j < signal.values.cols(); ++j) table.rows.back().emplace_back(signal.values(s, j));
  }
  return table;
}

std::vector<double> middles(const Eigen::MatrixXd& values) {
  const Eigen::RowVectorXd middle = 0.5 * (values.colwise().maxCoeff() + values.colwise().minCoeff());
  return {middle.begin(), middle.end()};
}

Figure sectors_figure(const Study& study, const SectorSignal& signal, const std::string& name,
                      const std::string& title) {
  constexpr double clear_of_each_other = 1.15, smallest_spacing = 1e-9;
  const int revolutions = drawn_revolutions(study.shown_response());
  const int samples_per_revolution = study.shown_response().samples_per_revolution;
  const double spacing = std::max(2 * clear_of_each_other * vibration_amplitude(signal.values), smallest_spacing);
  const std::string bar_label = fixed(0.5 * spacing, 3) + " " + signal.unit;
  return {.drawing = {.name = name,
                      .width = 1000,
                      .height = 640,
                      .script = "sectors",
                      .values = {{"revolutions", revolutions},
                                 {"sectors", static_cast<int>(signal.values.cols())},
                                 {"middle", middles(signal.values)},
                                 {"spacing", spacing},
                                 {"bar_label", bar_label}}},
          .title = title,
          .caption = signal.what + ", at " + shown_speed_text(study) + ", one sector above the other; the bar is " +
                     bar_label +
                     " long. In a fully symmetric steady motion each sector repeats its neighbour's signal.",
          .data = signal_table(signal, static_cast<Eigen::Index>(samples_per_revolution) * revolutions,
                               samples_per_revolution)};
}

}  // namespace

Figure tip_motion_figure(const Study& study) {
  return sectors_figure(study, motion_of_sectors(study), "tip_motion", "Motion of all sectors");
}

Figure force_of_sectors_figure(const Study& study) {
  return sectors_figure(study, force_of_sectors(study), "force_of_sectors", "Contact force on all sectors");
}

}  // namespace tiprub
