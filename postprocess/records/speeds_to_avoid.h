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
  SpeedRange speeds;  ///< its ends are the nearest speeds without the concern, or the ends of the sweep
  Concern concern = Concern::beyond_clearance;
};

/// The bands, the gravest concern first, each in ascending speed. Stress is known at critical speeds; beside one, it
/// is taken to fall with the amplitude, and its band spans at least the interval in which that speed lies.
std::vector<AvoidedBand> speeds_to_avoid(const Study& study, const FieldResults& fields);

/// "19250 to 19546 rpm (Goodman above 1), ...", or that there are none.
std::string bands_in_words(const std::vector<AvoidedBand>& bands, const FieldResults& fields);

}  // namespace tiprub::postprocess
