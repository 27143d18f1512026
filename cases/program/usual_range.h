// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "cases/program/case_file.h"

namespace tiprub {

/// Raises InputError at a key whose value is possible, but outside of what is usual for matter and machines: such
/// values are mostly numbers in another unit. A table that is read so has the key `unusual`, and is not checked if
/// that is true.
void require_usual(const CaseTable& table, std::string_view key, double value, const Range& usual,
                   std::string_view unit);

}  // namespace tiprub
