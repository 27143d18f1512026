// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

/// All rows, or those without the errors of the settings.
enum class BudgetRows { all, data_and_physics };

/// The effect of one source of error on a critical speed. All changes are relative [1].
struct BudgetRow {
  std::string source;    ///< "clearance -0.02 mm"
  std::string failure;   ///< empty, or why the numbers below are not known
  double shift = 0;      ///< of the speed, with its sign if that is known
  double amplitude = 0;  ///< of the amplitude, in the same way
  double excursion = 0;  ///< of the motion of the tip in all directions together, in the same way
  /// Of the largest stress of the vibration in the body, in the same way; empty if it was not recovered.
  std::optional<double> stress = {};
  std::string motion = {};  ///< class of the motion at the peak; empty if it was not marched
  bool is_bound = false;    ///< an upper bound, far above what is likely; not in the sum
  bool is_poorer = false;   ///< a poorer model than that of the case, for comparison; not in the sum
  bool only_speed = false;  ///< what it does to the amplitude, to |u| and to the stress is not known

  /// An error of the settings, which computing time can remove; other rows are data and physics.
  bool is_setting = false;
  /// The largest of the critical speeds whose peaks come to the same place with this change, if it is larger than
  /// that of the row: there is one peak then. Null otherwise.
  const CriticalSpeed* joined = nullptr;

  bool in_sum() const { return !is_bound && !is_poorer; }
  bool is_among(BudgetRows rows) const { return rows == BudgetRows::all || !is_setting; }
};

/// The error budget of one critical speed: the variations of tiprub-simulate, and the errors of the settings.
struct ErrorBudget {
  const CriticalSpeed* critical = nullptr;
  double excursion = 0;  ///< [m] largest_excursion() at the critical speed
  double stress = 0;     ///< [Pa] the largest of the vibration in the body; 0 if it was not recovered
  std::vector<BudgetRow> rows;
};

/// The table of critical speeds for a decision: place, motion and stress of each, and what changes each of them most.
Table critical_speed_budgets(const Study& study, const FieldResults& fields);

/// The budgets of all critical speeds for which the response has variations. Amplitudes are along the normal, whose
/// peaks tiprub-simulate follows.
std::vector<ErrorBudget> followed_peaks(const Study& study, const FieldResults& fields);
/// The same for the reader; none if the study is of another component.
std::vector<ErrorBudget> error_budgets(const Study& study, const FieldResults& fields);

/// The budget of the critical speed with the largest amplitude; the list must not be empty.
const ErrorBudget& largest_budget(const std::vector<ErrorBudget>& budgets);

/// The sum over the sources: the root of the sum of squares, as if the sources were independent and their effects
/// added up. Of the rows of one source, such as both signs of the clearance, only the largest counts. Bounds and
/// poorer models are left out.
struct BudgetSum {
  double shift = 0, amplitude = 0, excursion = 0, stress = 0;  ///< [1] as in BudgetRow
  double stress_rise = 0;                                      ///< [1] of the rows that raise the stress
};
BudgetSum sum_of(const ErrorBudget& budget, BudgetRows rows = BudgetRows::all);
/// "friction 0.1, clearance +0.02 mm": the rows that have failed, so that the sum leaves them out.
std::string not_in_sum(const ErrorBudget& budget, BudgetRows rows = BudgetRows::all);
/// The rows whose peaks were found and whose stress was not recovered, so that the sum of the stress leaves them out.
std::string not_in_stress_sum(const ErrorBudget& budget);

/// What a budget leaves open of one quantity of its critical speed.
struct OpenQuantity {
  std::string what;     ///< "speed", "amplitude", "|u|", "stress"
  double together = 0;  ///< [1] of BudgetSum
  std::string most;     ///< its largest row: "friction 0.1 (-2.9 %)"
};
/// The one that is least certain first.
std::vector<OpenQuantity> open_quantities(const ErrorBudget& budget);

/// The table error_budget.csv: a row for each critical speed and source, and one for the sum over the sources.
Table error_budget_record(const Study& study, const FieldResults& fields);

}  // namespace tiprub::postprocess
