// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/study_figures.h"
#include "postprocess/records/branch_record.h"
#include "postprocess/records/sweep_record.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

/// Speed [rpm], from rest, up, down [mm], the last two once more where they differ; NaN where there is nothing.
Eigen::MatrixXd sweep_rows(const Study& study) {
  const Eigen::VectorXd rpm = speeds_rpm(study);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Constant(rpm.size(), 6, std::nan(""));
  rows.col(0) = rpm;
  rows.col(1) = study.amplitudes.largest * mm_per_m;
  for (const SweepComparison& comparison : study.sweeps) {
    const Eigen::Index i = comparison.index;
    const auto enter = [&](const std::optional<SweptSpeed>& swept, Eigen::Index column) {
      if (swept) rows(i, column) = swept->amplitude * mm_per_m;
      if (swept && swept->differs) rows(i, column + 2) = swept->amplitude * mm_per_m;
    };
    enter(comparison.up, 2);
    enter(comparison.down, 3);
  }
  return rows;
}

/// Speed [rpm], amplitude [mm] of each run of orbits that attract, or of those that repel; the latter reach to their
/// neighbours.
std::vector<Eigen::MatrixXd> runs(const OrbitBranch& branch, bool attracting) {
  std::vector<Eigen::MatrixXd> found;
  const Eigen::Index count = branch.speed.size();
  for (Eigen::Index first = 0, last = 0; first < count; first = last + 1) {
    for (last = first; last + 1 < count && branch.attracts(last + 1) == branch.attracts(first);) ++last;
    if (branch.attracts(first) != attracting) continue;
    const Eigen::Index from = attracting ? first : std::max<Eigen::Index>(first - 1, 0);
    const Eigen::Index to = attracting ? last : std::min(last + 1, count - 1);
    Eigen::MatrixXd run(to - from + 1, 2);
    run << branch.speed.segment(from, run.rows()) * rpm_per_rad_s,
        branch.amplitude.segment(from, run.rows()) * mm_per_m;
    found.push_back(run);
  }
  return found;
}

}  // namespace

Figure sweeps_figure(const Study& study) {
  Figure figure{.drawing = {.name = "sweeps",
                            .width = 1000,
                            .height = 480,
                            .script = "sweeps",
                            .values = {{"sweeps_drawn", 1}},
                            .tables = {{"sweeps", {sweep_rows(study)}}, {"attracting", {}}, {"repelling", {}}}},
                .title = "From rest, upwards, downwards",
                .caption =
                    "Amplitude of the motion that each speed settles to from rest, and from the motion at the "
                    "speed below (up) and above (down). Where motions differ (filled), there is more than one, "
                    "and the wheel's past decides.",
                .data = sweep_record(study)};
  set_speed_axis(figure.drawing, speed_axis(study));
  return figure;
}

Figure branches_figure(const Study& study) {
  ScriptTable attracting{"attracting", {}}, repelling{"repelling", {}};
  DrawnRange range{study.response.branches.front().speed[0] * rpm_per_rad_s, 0};
  for (const OrbitBranch& branch : study.response.branches) {
    for (const Eigen::MatrixXd& run : runs(branch, true)) attracting.sheets.push_back(run);
    for (const Eigen::MatrixXd& run : runs(branch, false)) repelling.sheets.push_back(run);
    range.low = std::min(range.low, branch.speed.minCoeff() * rpm_per_rad_s);
    range.high = std::max(range.high, branch.speed.maxCoeff() * rpm_per_rad_s);
  }
  return {.drawing = {.name = "branches",
                      .width = 1000,
                      .height = 480,
                      .script = "sweeps",
                      .values = {{"speed", range}, {"sweeps_drawn", study.sweeps.empty() ? 0 : 1}},
                      .tables = {{"sweeps", {sweep_rows(study)}}, std::move(attracting), std::move(repelling)}},
          .title = "Branches of orbits",
          .caption =
              "Orbits that travel with the casing, followed over speed: solid where they attract, dashed where they "
              "repel, so that no march shows them. Where a curve turns back, orbits begin or end in pairs. The thin "
              "line: the "
              "motion from rest; beside a dashed line alone it is of another kind, which swells and falls.",
          .data = branch_record(study)};
}

}  // namespace tiprub
