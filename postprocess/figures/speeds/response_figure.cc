// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

Table amplitude_table(const Study& study) {
  const TipAmplitudes& amplitudes = study.amplitudes;
  const Eigen::VectorXd rpm = speeds_rpm(study);
  Table table{{"speed [rpm]", "largest [mm]", "leading edge [mm]", "trailing edge [mm]", "node of the largest"}, {}};
  for (Eigen::Index i = 0; i < rpm.size(); ++i)
    table.rows.push_back({rpm[i], amplitudes.largest[i] * mm_per_m, amplitudes.by_node(0, i) * mm_per_m,
                          amplitudes.by_node(study.model.contact.trailing_edge(), i) * mm_per_m, amplitudes.node[i]});
  return table;
}

/// Speed [rpm], amplitude [mm] where the motion is not the same every revolution.
Eigen::MatrixXd not_periodic(const Study& study) {
  std::vector<double> speeds, amplitudes;
  for (std::size_t i = 0; i < study.response.speeds.size(); ++i) {
    if (study.response.speeds[i].motion == MotionClass::periodic) continue;
    speeds.push_back(study.response.speeds[i].speed * rpm_per_rad_s);
    amplitudes.push_back(study.amplitudes.largest[static_cast<Eigen::Index>(i)] * mm_per_m);
  }
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(speeds.size()), 2);
  rows << as_column(speeds), as_column(amplitudes);
  return rows;
}

/// Speed [rpm], amplitude [mm].
Eigen::MatrixXd peaks(const Study& study) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(study.critical.size()), 2);
  for (std::size_t i = 0; i < study.critical.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) << study.critical[i].speed * rpm_per_rad_s,
        study.critical[i].amplitude * mm_per_m;
  return rows;
}

/// The waves that make the peaks: "EO 6 ND -4".
std::vector<std::string> peak_names(const Study& study) {
  std::vector<std::string> names;
  for (const CriticalSpeed& critical : study.critical) names.push_back(wave_name(critical.rising));
  return names;
}

/// [rpm]
Eigen::MatrixXd speeds_of(const std::vector<Crossing>& crossings) {
  std::vector<double> speeds;
  speeds.reserve(crossings.size());
  for (const Crossing& crossing : crossings) speeds.push_back(crossing.speed * rpm_per_rad_s);
  return as_column(speeds);
}

}  // namespace

Figure response_figure(const Study& study) {
  Figure figure{
      .drawing = {.name = "response",
                  .width = 1000,
                  .height = 520,
                  .script = "response",
                  .values = {{"amplitude", DrawnRange{0, study.amplitudes.largest.maxCoeff() * mm_per_m}},
                             {"peak_name", peak_names(study)}},
                  .tables = {{"peaks", {peaks(study)}},
                             {"not_periodic", {not_periodic(study)}},
                             {"aliased", {speeds_of(drawn_crossings(study, study.aliased))}},
                             {"equation_2", {speeds_of(drawn_crossings(study, study.equation_2))}},
                             {"failed", {rpm_of(study.failed)}}}},
      .title = "Response",
      .caption = std::string("Half of the peak-to-peak ") + name_of(study.parameters.component) +
                 ", the largest over sectors. Each critical speed carries the engine order and signed nodal diameter "
                 "(+ backward, - forward) of the wave that makes it. Triangles at the foot: speeds "
                 "predicted by the linear rules for the drawn families. Rings: motion that is not the same every "
                 "revolution.",
      .data = amplitude_table(study)};
  set_speed_axis(figure.drawing, speed_axis(study));
  return figure;
}

}  // namespace tiprub
