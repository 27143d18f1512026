// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/fields/field_results.h"

namespace tiprub {

/// What else was found, beside the verdict, in words: stress, what the linear rules missed, how far the numbers may
/// be trusted, what is unusual. One paragraph a line.
std::vector<std::string> summary(const Study& study, const FieldResults& fields);

/// "1 speed", "3 speeds".
std::string counted(std::size_t count, const std::string& what);

}  // namespace tiprub
