// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/program/case_file.h"

namespace tiprub {

/// [m] of one unit of the key `length_unit`: m, cm, mm or in.
double read_length_unit(CaseTable& table);

}  // namespace tiprub
