// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/exactness_record.h"

#include <algorithm>
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
  double worst_speed = 0;
  int looked_at = 0;
  for (const SpeedResponse& speed : study.response.speeds) {
    const std::optional<double> here = number(speed);
    if (!here) continue;
    ++looked_at;
    if (worst && std::abs(*here) <= *worst) continue;
    worst = std::abs(*here);
    worst_speed = speed.speed * rpm_per_rad_s;
  }
  if (!worst) return {check, std::string(), std::string(), 0};
  return {check, *worst, *worst > 0 ? Cell(worst_speed) : Cell(std::string()), looked_at};
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
  table.rows.push_back(
      {std::string("model: frequencies by the polynomial stiffness (eq. 7) alone, between its speeds [1]"), largest,
       model.verification.speeds[row] * rpm_per_rad_s, speeds});
}

}  // namespace

Table exactness_record(const Study& study) {
  Table table{{"check", "worst", "at [rpm]", "speeds looked at"}, {}};
  append_model(table, study.model);
  const auto add = [&](const char* check, const Number& number) {
    table.rows.push_back(row_of(study, check, number));
  };
  add("time step: relative change by the last halving [1]",
      [](const SpeedResponse& speed) { return speed.audit.halving_difference; });
  add("settling: relative change over the last period, of settled motions [1]",
      [](const SpeedResponse& speed) -> std::optional<double> {
        if (!speed.settled()) return {};
        return speed.change;
      });
  add("energy: closing error of the balance [1]",
      [](const SpeedResponse& speed) { return speed.energy.closing_error; });
  add("contact: penetration into the casing [mm]",
      [](const SpeedResponse& speed) { return speed.largest_penetration * mm_per_m; });
  add("contact: recorded steps that end with a node in penetration",
      [](const SpeedResponse& speed) { return static_cast<double>(speed.audit.leftover_steps); });
  add("contact: tensile share of the contact force [1]",
      [](const SpeedResponse& speed) { return speed.audit.tension_share; });
  add("massless and truncated modes: share of the elastic energy [1]",
      [](const SpeedResponse& speed) { return speed.audit.left_out_energy; });
  add("symmetry: growth per revolution of the nodal diameters left out, stable below 1 [1]",
      [](const SpeedResponse& speed) { return speed.audit.excluded_growth; });
  if (std::any_of(study.response.speeds.begin(), study.response.speeds.end(),
                  [](const SpeedResponse& speed) { return speed.audit.rest_difference.has_value(); }))
    add("sweep: relative difference from the response from rest [1]",
        [](const SpeedResponse& speed) { return speed.audit.rest_difference; });
  return table;
}

}  // namespace tiprub
