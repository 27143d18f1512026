// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

/// How far the casing is from a node of the rotor that spins and doesn't vibrate, around the casing [mm].
Eigen::VectorXd gap(const Study& study, Eigen::Index node) {
  const double clearance = study.shown_response().clearance[node];
  return ((clearance - study.response.scene.casing_distortion.array()) * mm_per_m).matrix();
}

}  // namespace

Figure casing_figure(const Study& study) {
  constexpr double smallest_distortion = 1e-12;  // [m] of a round casing
  const SimulatedScene& scene = study.response.scene;
  const double largest = std::max(scene.casing_distortion.cwiseAbs().maxCoeff(), smallest_distortion);
  Figure figure{
      .drawing = {.name = "casing",
                  .width = 1000,
                  .height = 430,
                  .script = "casing",
                  .values = {{"largest_distortion", largest * mm_per_m}}},
      .title = "Casing",
      .caption = "Left: the shape, its largest distortion of " + fixed(largest * mm_per_m, 3) +
                 " mm drawn as a fifth of the radius; dashed: the round casing. Right: the gap between the casing "
                 "and the tip" +
                 of_main_blade(study) + " that spins at " + rpm_text(study.shown_response().speed) +
                 " without vibrating; below zero the blade has to bend.",
      .data = {{"angle [deg]", "gap at leading edge [mm]", "gap at trailing edge [mm]", "distortion [mm]"}, {}}};
  const Eigen::VectorXd leading = gap(study, 0), trailing = gap(study, study.model.contact.trailing_edge());
  for (Eigen::Index i = 0; i < scene.casing_angle.size(); ++i)
    figure.data.rows.push_back({scene.casing_angle[i] * 360.0 / (2 * std::numbers::pi), leading[i], trailing[i],
                                scene.casing_distortion[i] * mm_per_m});
  return figure;
}

}  // namespace tiprub
