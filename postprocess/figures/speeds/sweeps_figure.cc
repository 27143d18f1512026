// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/records/sweep_record.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

/// Speed [rpm], from rest, up, down [mm], the last two once more where they differ; NaN where there is nothing.
Eigen::MatrixXd sweep_rows(const Study& study) {
  const Eigen::VectorXd rpm = speeds_rpm(study);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(rpm.size(), 6, std::nan(""));
  for (const SweepComparison& comparison : study.sweeps) {
    const Eigen::Index i = comparison.index;
    rows.row(i).head<2>() << rpm[i], study.amplitudes.largest[i] * mm_per_m;
    const auto enter = [&](const std::optional<SweptSpeed>& swept, Eigen::Index column) {
      if (swept) rows(i, column) = swept->amplitude * mm_per_m;
      if (swept && swept->differs) rows(i, column + 2) = swept->amplitude * mm_per_m;
    };
    enter(comparison.up, 2);
    enter(comparison.down, 3);
  }
  return rows;
}

}  // namespace

Figure sweeps_figure(const Study& study) {
  Figure figure{.drawing = {.name = "sweeps",
                            .width = 1000,
                            .height = 480,
                            .script = "sweeps",
                            .tables = {{"sweeps", {sweep_rows(study)}}}},
                .title = "From rest, upwards, downwards",
                .caption =
                    "Amplitude of the motion that each speed settles to from rest, and from the motion at the "
                    "speed below (up) and above (down). Where motions differ (filled), there is more than one, "
                    "and the wheel's past decides.",
                .data = sweep_record(study)};
  set_speed_axis(figure.drawing, speed_axis(study));
  return figure;
}

}  // namespace tiprub
