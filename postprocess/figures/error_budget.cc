// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "postprocess/figures/study_figures.h"

namespace tiprub::postprocess {

Figure error_budget_figure(const ErrorBudget& budget) {
  const double speed = budget.critical->speed * rpm_per_rad_s, excursion = budget.excursion * mm_per_m,
               stress = budget.stress * mpa_per_pa;
  const bool stressed = stress > 0;
  std::vector<std::string> panels = {"critical speed [rpm]", "tip |u| [mm]"},
                           at = {fixed(speed, 0), fixed(excursion, 2)};
  if (stressed) {
    panels.emplace_back("stress of the vibration [MPa]");
    at.push_back(fixed(stress, 0));
  }
  Table data{{"source", "kind", "change of speed [rpm]", "change of |u| [mm]", "change of stress [MPa]"}, {}};
  const auto times = [](const std::optional<double>& change, double value) {
    return change ? Cell(*change * value) : Cell(NoNumber{});
  };
  const auto add = [&](const std::string& source, const char* kind, double shift,
                       const std::optional<double>& further, const std::optional<double>& higher) {
    data.rows.push_back({source, std::string(kind), shift * speed, times(further, excursion),
                         times(stressed ? higher : std::nullopt, stress)});
  };
  for (const BudgetRow& row : budget.rows)
    if (row.failure.empty() && row.in_sum())
      add(row.source, row.is_setting ? "setting" : "data", row.shift,
          row.only_speed ? std::nullopt : std::optional(row.excursion), row.stress);
  const BudgetSum sum = sum_of(budget);
  add("all together", "sum", sum.shift, sum.excursion, sum.stress);
  const auto bound = std::ranges::find_if(budget.rows, &BudgetRow::is_bound);
  Figure figure = listed_figure(
      "error_budget", {{"speed", rpm_text(budget.critical->speed)},
                       {"wave", wave_names(*budget.critical)},
                       {"bound", bound == budget.rows.end() ? "" : fixed(percent * bound->excursion, 0) + " %"}});
  std::vector<std::string> sources;
  for (const auto& row : data.rows) sources.push_back(std::get<std::string>(row.front()));
  figure.drawing.values = {{"panel_title", panels}, {"panel_value", at}, {"source", sources}};
  figure.data = std::move(data);
  return figure;
}

}  // namespace tiprub::postprocess
