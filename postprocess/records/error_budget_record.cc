// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/error_budget_record.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>

#include "postprocess/records/exactness_record.h"
#include "postprocess/records/scene_needs_record.h"
#include "postprocess/records/study_records.h"

namespace tiprub::postprocess {

namespace {

std::string signed_text(double value, int digits) {
  return (value >= 0 ? "+" : "") + significant(value, digits);
}

/// "+75 %", "+173 %"
std::string change_text(double change) {
  constexpr double large = 0.995;
  return (std::abs(change) < large ? signed_text(percent * change, 2)
                                   : (change > 0 ? "+" : "") + fixed(percent * change, 0)) +
         " %";
}

/// "contact at points", "contact on segments", "model of 28 segments".
std::string other_model(int segments, const ContactLine& own) {
  const int own_segments = own.kind == ContactKind::segments ? own.size() - own.splitter_nodes : 0;
  if (segments == own_segments) return "another model";
  if (segments == 0) return "contact at points";
  return own_segments == 0 ? "contact on segments" : "model of " + std::to_string(segments) + " segments";
}

std::string source_of(const PeakVariation& variation, const ContactLine& own) {
  constexpr int digits = 3;
  switch (variation.what) {
    case Variation::friction:
      return "friction " + significant(variation.setting, digits);
    case Variation::damping:
      return "damping " + significant(variation.setting, digits);
    case Variation::clearance:
      return "clearance " + signed_text(variation.setting * mm_per_m, digits) + " mm";
    case Variation::gap:
      return variation.setting > 1 ? "gap of second order" : "linear gap";
    case Variation::step:
      return "half the time step";
    case Variation::model:
      return other_model(static_cast<int>(variation.setting), own);
  }
  return name_of(variation.what);
}

/// `stress` [Pa] is that of the varied peak, if it was recovered.
BudgetRow row_of(const PeakVariation& variation, const std::optional<double>& stress, const SpeedResponse& response,
                 const ErrorBudget& budget, const ContactLine& own) {
  BudgetRow row{source_of(variation, own), variation.failure};
  row.is_setting = variation.what == Variation::step || variation.what == Variation::model;
  row.is_poorer = variation.what == Variation::gap && variation.setting == 1;
  if (!row.failure.empty()) return row;
  row.shift = variation.speed / response.speed - 1;
  row.amplitude = variation.amplitude / response.amplitude - 1;
  row.excursion = variation.excursion / budget.excursion - 1;
  if (stress && budget.stress > 0) row.stress = *stress / budget.stress - 1;
  row.motion = motion_text(variation.motion, variation.period_beats);
  return row;
}

/// An error of the model's frequencies.
BudgetRow of_frequencies(const std::string& source, double shift) {
  BudgetRow row{source, "", shift};
  row.only_speed = true;
  return row;
}

/// The errors of the settings. They have no sign, but for the mesh, which makes frequencies too high.
void add_settings(const Study& study, const SpeedResponse& response, ErrorBudget& budget) {
  const CriticalSpeed& critical = *budget.critical;
  const double rise = critical.amplitude_high / critical.amplitude - 1;
  budget.rows.push_back({"speeds beside the peak", "", critical.spacing / critical.speed, rise, rise, rise});
  const bool marched = std::ranges::count(response.budget, Variation::step, &PeakVariation::what) > 0;
  if (const auto step = response.audit.halving_difference; step && !marched)
    budget.rows.push_back({"time step", response.audit.halving_failure, 0, *step, *step, *step});
  const std::vector<Check> checks = exactness_checks(study);
  // The first check of the model is of all its errors, that of the polynomial stiffness included.
  const auto model = std::ranges::find(checks, "model", &Check::subject);
  if (model != checks.end() && model->worst) budget.rows.push_back(of_frequencies("reduced modes", *model->worst));
  if (const auto shift = mesh_shift(study.model, critical.naming_wave()))
    budget.rows.push_back(of_frequencies("mesh", -*shift));
}

/// Whitehead (1966): in a linear wheel whose blades differ, one of N blades moves at most (1 + sqrt N)/2 times as far
/// as in a wheel of equal ones under the same forces.
BudgetRow differing_blades(int blades) {
  const double rise = (1 + std::sqrt(static_cast<double>(blades))) / 2 - 1;
  return {"blades that differ", "", 0, rise, rise, rise, "an upper bound, not in the sum", true};
}

constexpr double same_place = 2e-3;  // of the speed: the least half-width with which a peak is followed

bool come_together(const ErrorBudget& one, const BudgetRow& row, const ErrorBudget& other, const BudgetRow& there) {
  const double ratio = other.critical->speed * (1 + there.shift) / (one.critical->speed * (1 + row.shift));
  return there.source == row.source && !there.motion.empty() && std::abs(ratio - 1) < same_place;
}

void find_joined(std::vector<ErrorBudget>& budgets) {
  for (ErrorBudget& budget : budgets)
    for (BudgetRow& row : budget.rows) {
      if (row.motion.empty() || row.is_bound) continue;
      double largest = budget.excursion;
      for (const ErrorBudget& other : budgets)
        for (const BudgetRow& there : other.rows)
          if (other.excursion > largest && come_together(budget, row, other, there)) {
            row.joined = other.critical;
            largest = other.excursion;
          }
    }
}

/// 0 where it is not known.
double stress_change(const BudgetRow& row) {
  return row.stress.value_or(0);
}

/// The row of the sum with the largest absolute value.
template <class Value>
const BudgetRow& largest(const ErrorBudget& budget, Value value) {
  return *std::ranges::max_element(budget.rows, [&](const BudgetRow& a, const BudgetRow& b) {
    return !a.in_sum() || (b.in_sum() && std::abs(std::invoke(value, a)) < std::abs(std::invoke(value, b)));
  });
}

template <class Value>
double sum_over_sources(const ErrorBudget& budget, BudgetRows rows, Value value) {
  std::map<std::string, double> by_source;
  for (const BudgetRow& row : budget.rows) {
    if (!row.in_sum() || !row.is_among(rows)) continue;
    double& most = by_source[row.source.substr(0, row.source.find(' '))];
    most = std::max(most, std::abs(std::invoke(value, row)));
  }
  double sum = 0;
  for (const auto& [source, most] : by_source) sum += most * most;
  return std::sqrt(sum);
}

template <class Condition>
std::string sources_of(const ErrorBudget& budget, Condition condition) {
  return listed(budget.rows, ", ", [&](const BudgetRow& row) { return condition(row) ? row.source : ""; });
}

/// "friction 0.1 (-2.9 %)", "damping 0.002 (+2044 %, joins 19622 rpm)": the row that changes a value most; empty
/// without rows.
template <class Value>
std::string largest_text(const ErrorBudget* budget, Value value) {
  if (budget == nullptr) return "no budget";
  const BudgetRow& row = largest(*budget, value);
  const std::string joined =
      row.joined == nullptr ? "" : ", joins " + fixed(row.joined->speed * rpm_per_rad_s, 0) + " rpm";
  return row.source + " (" + change_text(std::invoke(value, row)) + joined + ")";
}

std::string largest_stress_text(const ErrorBudget* budget) {
  const std::string missing = budget == nullptr ? "" : not_in_stress_sum(*budget);
  return largest_text(budget, stress_change) + (missing.empty() ? "" : ", without " + missing);
}

std::string stress_text(const std::optional<FieldPeak>& stress) {
  if (!stress) return "";
  return (stress->cycle ? "" : "> ") + fixed(stress->body.vibration * mpa_per_pa, 0) + " / " +
         fixed(stress->body.both * mpa_per_pa, 0);
}

std::string goodman_text(const std::optional<FieldPeak>& stress) {
  if (!stress || !stress->cycle || !stress->cycle->goodman) return "";
  const double utilisation = *stress->cycle->goodman;
  return fixed(utilisation, 2) + (utilisation > 1 ? " > 1" : "");
}

}  // namespace

std::vector<ErrorBudget> error_budgets(const Study& study, const FieldResults& fields) {
  return study.parameters.component == Component::normal ? followed_peaks(study, fields) : std::vector<ErrorBudget>{};
}

std::vector<ErrorBudget> followed_peaks(const Study& study, const FieldResults& fields) {
  std::vector<ErrorBudget> budgets;
  for (std::size_t i = 0; i < study.critical.size(); ++i) {
    const SpeedResponse& response = study.speed_at(study.critical[i].index);
    if (response.budget.empty()) continue;
    const auto& stress = fields.peaks[i];
    ErrorBudget budget{
        &study.critical[i], study.excursion_at(study.critical[i].index), stress ? stress->body.vibration : 0, {}};
    for (std::size_t k = 0; k < response.budget.size(); ++k)
      budget.rows.push_back(row_of(response.budget[k],
                                   k < fields.varied[i].size() ? fields.varied[i][k] : std::nullopt, response, budget,
                                   study.model.contact));
    const std::size_t varied = budget.rows.size();
    add_settings(study, response, budget);
    for (std::size_t k = varied; k < budget.rows.size(); ++k) budget.rows[k].is_setting = true;
    budget.rows.push_back(differing_blades(study.response.scene.sector_count));
    budgets.push_back(std::move(budget));
  }
  find_joined(budgets);
  return budgets;
}

const ErrorBudget& largest_budget(const std::vector<ErrorBudget>& budgets) {
  return *std::ranges::max_element(budgets, {}, [](const ErrorBudget& budget) { return budget.critical->amplitude; });
}

BudgetSum sum_of(const ErrorBudget& budget, BudgetRows rows) {
  const auto sum = [&](auto value) { return sum_over_sources(budget, rows, value); };
  return {sum(&BudgetRow::shift), sum(&BudgetRow::amplitude), sum(&BudgetRow::excursion), sum(stress_change),
          sum([](const BudgetRow& row) { return std::max(0.0, stress_change(row)); })};
}

std::string not_in_sum(const ErrorBudget& budget, BudgetRows rows) {
  return sources_of(budget, [&](const BudgetRow& row) { return !row.failure.empty() && row.is_among(rows); });
}

std::string not_in_stress_sum(const ErrorBudget& budget) {
  if (budget.stress == 0) return "";
  return sources_of(budget, [](const BudgetRow& row) { return !row.motion.empty() && row.in_sum() && !row.stress; });
}

Table critical_speed_budgets(const Study& study, const FieldResults& fields) {
  Table table{
      {"critical speed [rpm]", "lies between [rpm]", "wave", "tip |u| [mm]",
       study.parameters.component == Component::normal ? std::string("along the normal [mm]")
                                                       : std::string(name_of(study.parameters.component)) + " [mm]"},
      {}};
  if (fields.has_stress()) table.header.insert(table.header.end(), {"vibration / with spin [MPa]", "Goodman"});
  table.header.insert(table.header.end(),
                      {"moves the speed most", "moves |u| most", "validity: second order / interference"});
  if (fields.has_stress()) table.header.insert(std::prev(table.header.end()), "moves the stress most");
  const std::vector<ErrorBudget> budgets = error_budgets(study, fields);
  for (std::size_t i = 0; i < study.critical.size(); ++i) {
    const CriticalSpeed& critical = study.critical[i];
    const auto found = std::ranges::find(budgets, &critical, &ErrorBudget::critical);
    const ErrorBudget* const budget = found == budgets.end() ? nullptr : &*found;
    std::vector<Cell> row = {
        fixed(critical.speed * rpm_per_rad_s, 0),
        fixed(critical.speed_low * rpm_per_rad_s, 0) + " .. " + fixed(critical.speed_high * rpm_per_rad_s, 0),
        wave_names(critical), fixed(study.excursion_at(critical.index) * mm_per_m, 2),
        fixed(critical.amplitude * mm_per_m, 3)};
    if (fields.has_stress()) row.insert(row.end(), {stress_text(fields.peaks[i]), goodman_text(fields.peaks[i])});
    row.insert(row.end(), {largest_text(budget, &BudgetRow::shift), largest_text(budget, &BudgetRow::excursion)});
    if (fields.has_stress()) row.emplace_back(largest_stress_text(budget));
    row.emplace_back(validity_in_short(study, i, fields));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<OpenQuantity> open_quantities(const ErrorBudget& budget) {
  const BudgetSum sum = sum_of(budget);
  std::vector<OpenQuantity> all = {{"speed", sum.shift, largest_text(&budget, &BudgetRow::shift)},
                                   {"amplitude", sum.amplitude, largest_text(&budget, &BudgetRow::amplitude)},
                                   {"|u|", sum.excursion, largest_text(&budget, &BudgetRow::excursion)}};
  if (budget.stress > 0) all.push_back({"stress", sum.stress, largest_stress_text(&budget)});
  std::ranges::stable_sort(all, std::greater(), &OpenQuantity::together);
  return all;
}

Table error_budget_record(const Study& study, const FieldResults& fields) {
  Table table{{"critical speed [rpm]", "wave", "source", "speed [rpm]", "change of speed [%]", "amplitude [mm]",
               "change of amplitude [%]", "tip |u| [mm]", "change of |u| [%]", "stress [MPa]", "change of stress [%]",
               "motion", "joins the peak of [rpm]"},
              {}};
  for (const ErrorBudget& budget : error_budgets(study, fields)) {
    const CriticalSpeed& critical = *budget.critical;
    const auto add = [&](const BudgetRow& row) {
      std::vector<Cell> cells = {critical.speed * rpm_per_rad_s, wave_name(critical.naming_wave()), row.source};
      const auto put = [&](bool known, double value, double change) {
        cells.push_back(known ? Cell(value * (1 + change)) : NoNumber{});
        cells.push_back(known ? Cell(percent * change) : NoNumber{});
      };
      const bool known = row.failure.empty();
      put(known, critical.speed * rpm_per_rad_s, row.shift);
      put(known && !row.only_speed, critical.amplitude * mm_per_m, row.amplitude);
      put(known && !row.only_speed, budget.excursion * mm_per_m, row.excursion);
      put(known && row.stress && budget.stress > 0, budget.stress * mpa_per_pa, stress_change(row));
      cells.emplace_back(known ? row.motion + (row.is_poorer ? "; for comparison, not in the sum" : "")
                               : row.failure);
      cells.push_back(row.joined == nullptr ? Cell(NoNumber{}) : Cell(row.joined->speed * rpm_per_rad_s));
      table.rows.push_back(std::move(cells));
    };
    const SpeedResponse& response = study.speed_at(critical.index);
    add({"as computed", "", 0, 0, 0, 0, motion_text(response.motion, response.period_beats)});
    for (const BudgetRow& row : budget.rows) add(row);
    const BudgetSum sum = sum_of(budget);
    const auto without = [](const std::string& what, const std::string& missing) {
      return missing.empty() ? "" : what + missing;
    };
    const std::array missing = {without("without ", not_in_sum(budget)),
                                without("stress without ", not_in_stress_sum(budget))};
    add({"root of the sum of squares", "", sum.shift, sum.amplitude, sum.excursion, sum.stress,
         listed(missing, "; ")});
  }
  return table;
}

}  // namespace tiprub::postprocess
