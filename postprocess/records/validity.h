// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"

namespace tiprub::postprocess {

/// What the motion at a critical speed leaves of the range in which its model holds, with the numbers; empty if it
/// stays inside.
std::string outside_validity(const Study& study, std::size_t critical, const FieldResults& fields);

/// "inside", "outside: 0.12 / 0.037 mm" (the gap's terms of second order and the interference), "outside: yield".
std::string validity_in_short(const Study& study, std::size_t critical, const FieldResults& fields);

}  // namespace tiprub::postprocess
