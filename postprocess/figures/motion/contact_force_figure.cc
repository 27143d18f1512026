// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

/// Engine order, then the amplitude of each signal.
Eigen::MatrixXd line_spectra(const Study& study, const Eigen::VectorXd& leading, const Eigen::VectorXd& trailing) {
  const int revolutions = study.shown_response().recorded_revolutions;
  const Eigen::VectorXd leading_lines = line_spectrum(leading), trailing_lines = line_spectrum(trailing);
  const int last =
      std::min(static_cast<int>(leading_lines.size()) - 1, study.parameters.engine_order_max * revolutions);
  Eigen::MatrixXd rows(last + 1, 3);
  for (int line = 0; line <= last; ++line)
    rows.row(line) << static_cast<double>(line) / revolutions, leading_lines[line], trailing_lines[line];
  return rows;
}

}  // namespace

Figure contact_force_figure(const Study& study) {
  const SpeedResponse& shown = study.shown_response();
  const SimulatedScene& scene = study.response.scene;
  const int last_node = study.model.contact.trailing_edge(), samples = shown.samples_per_revolution;
  const Eigen::VectorXd leading = tip_force(shown, scene, 0).col(0);
  const Eigen::VectorXd trailing = tip_force(shown, scene, last_node).col(0);
  Figure figure{.drawing = {.name = "contact_force",
                            .width = 1000,
                            .height = 520,
                            .script = "contact_force",
                            .values = {{"engine_order_max", study.parameters.engine_order_max}},
                            .tables = {{"lines", {line_spectra(study, leading, trailing)}}}},
                .title = "Contact force" + of_main_blade(study),
                .caption = "Sector 0 at " + fixed(shown.speed * rpm_per_rad_s, 0) +
                           " rpm, the first recorded revolution (above), and the spectrum over all recorded ones "
                           "(below). The force acts along the normal, from the casing on the blade.",
                .data = {{"rotor angle [deg]", "leading edge [N]", "trailing edge [N]"}, {}}};
  for (int s = 0; s < samples; ++s) figure.data.rows.push_back({360.0 * s / samples, leading[s], trailing[s]});
  return figure;
}

}  // namespace tiprub
