// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"

namespace tiprub::postprocess {

/// Why a wheel should not run at a speed, the gravest reason last.
enum class Concern {
  beyond_clearance,  ///< a tip moves towards the casing by more than its running clearance
  above_half,        ///< Goodman's utilisation is above 0.5
  above_limit,       ///< it is above 1
};

/// "tip moves beyond the clearance", "Goodman above 0.5", "Goodman above 1".
const char* name_of(Concern concern);

struct AvoidedBand {
  SpeedRange speeds;
  Concern concern = Concern::beyond_clearance;  ///< the gravest of all inside
  /// Where that concern was computed: from the nearest speed without it, or an end of the sweep, to the next.
  SpeedRange computed = {};
  /// [1] By how much each end was moved outwards: what the error budget of a critical speed inside leaves open of its
  /// speed; 0 without a budget.
  double widening = 0;
};

/// The bands in ascending speed; those that overlap are one. Stress is known at critical speeds; beside one, it is
/// taken to fall with the amplitude, and its band spans at least the interval in which that speed lies.
std::vector<AvoidedBand> speeds_to_avoid(const Study& study, const FieldResults& fields);

/// "Goodman above 1 from 19250 to 20500 rpm, with 3.4 % at each end by the error budget", or "Goodman above 0.5, not
/// widened without an error budget".
std::string reason_of(const AvoidedBand& band);

/// "18604 to 21188 rpm (Goodman above 1 ...); ...", or that there are none.
std::string bands_in_words(const std::vector<AvoidedBand>& bands, const FieldResults& fields);

}  // namespace tiprub::postprocess
