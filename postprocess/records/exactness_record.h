// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub {

/// Whether a check came out as it should.
enum class CheckVerdict {
  passed,
  failed,
  undecided,      ///< too near the limit to tell
  not_looked_at,  ///< at no speed
};

/// One thing that was checked, over the speeds.
struct Check {
  std::string subject;            ///< "time step"
  std::string what;               ///< what its number is, and its unit: "relative change by the last halving [1]"
  double limit = 0;               ///< the number must not be above
  std::optional<double> worst{};  ///< the largest of those looked at
  double speed = 0;               ///< [rad/s] where that is
  int looked_at = 0;              ///< speeds
  int speeds = 0;                 ///< that there are to look at
  int beyond = 0;                 ///< speeds above the limit
  CheckVerdict verdict = CheckVerdict::not_looked_at;
};

/// The model's frequencies, the time step, settling, the energy balance, contact, symmetry.
std::vector<Check> exactness_checks(const Study& study);

/// "yes", "no", "undecided", "not looked at": whether it passed.
std::string name_of(CheckVerdict verdict);

/// A row each: exactness.csv.
Table exactness_record(const Study& study);

}  // namespace tiprub
