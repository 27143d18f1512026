// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/exactness.h"

#include <cmath>
#include <functional>
#include <optional>

#include "postprocess/tables/units.h"
#include "reduce/model/verification.h"

namespace tiprub {

namespace {

/// One row from a number of every speed; none where simulate didn't look.
using Number = std::function<std::optional<double>(const SpeedResponse&)>;

std::vector<Cell> row_of(const Study& study, const std::string& check, const Number& number) {
  std::optional<double> worst;
  double speed = 0;
  int looked_at = 0;
  for (const SpeedResponse& at : study.response.speeds) {
    const std::optional<double> here = number(at);
    if (!here) continue;
    ++looked_at;
    if (worst && std::abs(*here) <= *worst) continue;
    worst = std::abs(*here);
    speed = at.speed * rpm_per_rad_s;
  }
  if (!worst) return {check, std::string(), std::string(), 0};
  return {check, *worst, *worst > 0 ? Cell(speed) : Cell(std::string()), looked_at};
}

void append_model(Table& table, const ReducedModel& model) {
  const ModelError error = model_error(model);
  const auto speeds = static_cast<int>(model.verification.speeds.size());
  if (error.frequencies == 0)
    table.rows.push_back(
        {std::string("model: frequencies against the unreduced sector [1]"), std::string(), std::string(), speeds});
  else
    table.rows.push_back({"model: the wheel's first " + std::to_string(error.frequencies) +
                              " frequencies against the unreduced sector [1]",
                          error.error, error.speed * rpm_per_rad_s, speeds});
  const Eigen::MatrixXd& misfit = model.verification.polynomial_misfit;
  if (misfit.size() == 0) return;
  Eigen::Index row = 0, column = 0;
  const double largest = misfit.maxCoeff(&row, &column);
  table.rows.push_back({std::string("model: frequencies, by the stiffness between its speeds (eq. 7) alone [1]"),
                        largest, model.verification.speeds[row] * rpm_per_rad_s, speeds});
}

}  // namespace

Table exactness_record(const Study& study) {
  Table table{{"check", "worst", "at [rpm]", "speeds looked at"}, {}};
  append_model(table, study.model);
  const auto add = [&](const char* check, const Number& number) {
    table.rows.push_back(row_of(study, check, number));
  };
  add("time step: what half of it changes [1]", [](const SpeedResponse& at) { return at.audit.halving_difference; });
  add("settling: change over the last period, of motions that repeat [1]",
      [](const SpeedResponse& at) -> std::optional<double> {
        if (at.motion == MotionClass::irregular) return {};
        return at.change;
      });
  add("energy: what its balance leaves over [1]", [](const SpeedResponse& at) { return at.energy.closing_error; });
  add("contact: penetration into the casing [mm]",
      [](const SpeedResponse& at) { return at.largest_penetration * mm_per_m; });
  add("contact: recorded steps that leave a node in the casing",
      [](const SpeedResponse& at) { return static_cast<double>(at.audit.leftover_steps); });
  add("contact: share of the force that pulls [1]", [](const SpeedResponse& at) { return at.audit.tension_share; });
  add("modes without mass or dropped: their share of the elastic energy [1]",
      [](const SpeedResponse& at) { return at.audit.left_out_energy; });
  add("symmetry: factor a turn of what was left out, decays below 1 [1]",
      [](const SpeedResponse& at) { return at.audit.excluded_growth; });
  if (std::any_of(study.response.speeds.begin(), study.response.speeds.end(),
                  [](const SpeedResponse& at) { return at.audit.rest_difference.has_value(); }))
    add("sweep: difference from the motion from rest [1]",
        [](const SpeedResponse& at) { return at.audit.rest_difference; });
  return table;
}

}  // namespace tiprub
