// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

/// The outcome of a check.
enum class CheckVerdict {
  passed,
  failed,
  undecided,      ///< too near the limit, or checked only beside the peaks
  not_looked_at,  ///< no speed was checked
};

/// One thing that was checked, over the speeds.
struct Check {
  std::string subject;            ///< "time step"
  std::string what;               ///< what its number is, and its unit: "relative change by the last halving [1]"
  double limit = 0;               ///< the largest number that passes
  std::optional<double> worst{};  ///< the largest number found
  double speed = 0;               ///< [rad/s] where that is
  int looked_at = 0;              ///< number of speeds that were checked
  int speeds = 0;                 ///< number of speeds that could be checked
  int beyond = 0;                 ///< number of speeds above the limit
  CheckVerdict verdict = CheckVerdict::not_looked_at;
};

/// [1] The error of the motion by the time step: estimated, or the change by the last halving; nothing if neither is
/// known.
std::optional<double> step_error(const SpeedResponse& speed, const AskedAccuracy& asked);

/// How many speeds have this verdict on the symmetry of their motion.
int speeds_with(SymmetryVerdict verdict, const Study& study);

/// Whether the speeds are close enough together to find every peak, and those beside each peak to resolve it.
std::vector<Check> speeds_checks(const Study& study);

/// Whether one of these failed. Then peaks may be higher, lie elsewhere or be missing, and no other check of the
/// response passes, because the largest motion may lie between the speeds that were checked.
bool speeds_too_far_apart(const Study& study);

/// A remark for numbers that depend on the peaks: empty, or " (not trustworthy: speeds too far apart)".
std::string speeds_caveat(const Study& study);

/// The speeds, the model's frequencies, the time step, settling, the energy balance, contact, symmetry.
std::vector<Check> exactness_checks(const Study& study);

/// "yes", "no", "undecided", "not looked at": whether it passed.
std::string name_of(CheckVerdict verdict);

/// A row for each check: exactness.csv.
Table exactness_record(const Study& study);

}  // namespace tiprub::postprocess
