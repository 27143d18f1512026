// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

/// What one source of error does to a critical speed. All changes are relative [1].
struct BudgetRow {
  std::string source;    ///< "clearance -0.02 mm"
  std::string failure;   ///< empty, or why the numbers below are not known
  double shift = 0;      ///< of the speed, with its sign where that is known
  double amplitude = 0;  ///< of the amplitude, likewise
  double excursion = 0;  ///< of the tip's motion in all directions together, likewise
  /// Of the largest stress of the vibration in the body, likewise; empty where it was not recovered.
  std::optional<double> stress = {};
  std::string motion = {};  ///< class of the motion there; empty where it was not marched
  bool is_bound = false;    ///< the most that is possible, far above what is likely
  bool is_setting = false;  ///< an error of the settings, which costs time to remove; others are data and physics
};

/// The error budget of one critical speed: what tiprub-simulate varied, and the errors of its own settings.
struct ErrorBudget {
  const CriticalSpeed* critical = nullptr;
  double excursion = 0;  ///< [m] largest_excursion() at the critical speed
  double stress = 0;     ///< [Pa] the largest of the vibration in the body there; 0 if it was not recovered
  std::vector<BudgetRow> rows;
};

/// The critical speeds as a decision needs them: place, motion, stress, and what moves each of them most.
Table critical_speed_budgets(const Study& study, const FieldResults& fields);

/// One for each critical speed for which the response has variations; empty without any.
std::vector<ErrorBudget> error_budgets(const Study& study, const FieldResults& fields);

/// The one with the largest amplitude; there must be one.
const ErrorBudget& worst_budget(const std::vector<ErrorBudget>& budgets);

/// The larger of two rows of one source, such as a clearance smaller and larger; over the sources the root of the sum
/// of squares, as if these were independent. Bounds are left out.
struct BudgetSum {
  double shift = 0, amplitude = 0, excursion = 0, stress = 0;  ///< [1] as BudgetRow has them
};
BudgetSum sum_of(const ErrorBudget& budget);

/// "At 19537 rpm, of all that was varied, the most for the speed: friction 0.1 (-2.9 %), all together 3.7 %; ...":
/// the largest row and the sum of each, of the budget with the largest amplitude; or empty.
std::string largest_errors(const Study& study, const FieldResults& fields);

/// "friction 0.1 (-2.9 %) moves the speed, damping 0.002 (+52 %) the motion of the tip, ... the stress": of the same
/// budget, or empty.
std::string largest_moves(const Study& study, const FieldResults& fields);

/// A row for each critical speed and source, and one with the sum over the sources: error_budget.csv.
Table error_budget_record(const Study& study, const FieldResults& fields);

}  // namespace tiprub::postprocess
