// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"

namespace tiprub::postprocess {

/// Why a wheel should not run at a speed, the gravest reason last.
enum class Concern {
  beyond_clearance,     ///< a tip moves towards the casing by more than its running clearance
  above_half,           ///< Goodman's utilisation is above 0.5
  perhaps_above_limit,  ///< it is above 1 if the stress grows by what the error budget leaves open
  above_limit,          ///< it is above 1
};

constexpr int concerns = 4;

/// "tip moves beyond the clearance", "Goodman above 0.5", "Goodman perhaps above 1", "Goodman above
/// 1".
const char* name_of(Concern concern);

struct AvoidedBand {
  SpeedRange speeds;
  Concern concern = Concern::beyond_clearance;  ///< the gravest at these speeds
  /// [1] By how much the ends of the concern's range were moved outwards: what the error budget of a critical speed
  /// inside leaves open of its speed; 0 without a budget.
  double widening = 0;
};

/// The bands in ascending speed; none overlap, and where several concerns meet, the gravest one has the band. Stress
/// is that of utilisation_over_speed(). A band ends at the nearest speeds at which its concern does not hold, and
/// spans at least the interval of each critical speed inside.
std::vector<AvoidedBand> speeds_to_avoid(const Study& study, const FieldResults& fields);

/// "Goodman above 1, 3.4 % at each end by the error budget", or "Goodman above 0.5, not widened without an error
/// budget".
std::string reason_of(const AvoidedBand& band);

/// "18362 to 21705 rpm (Goodman above 0.5; Goodman above 1 from 18604 to 21188 rpm; ...); ...": bands that touch are
/// one. Or that there are none. Then the critical speeds whose utilisation is estimated or not known.
std::string bands_in_words(const std::vector<AvoidedBand>& bands, const FieldResults& fields);

/// The speeds at which less is known than the bands suggest: those that failed, and those whose symmetric motion is
/// unstable although the whole wheel was not marched. " Not computed, because the march failed: 27000 and 30000
/// rpm."; may be empty.
std::string unknown_speeds(const Study& study);

}  // namespace tiprub::postprocess
