// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/program/command_line.h"

namespace tiprub {

/// tiprub-simulate case.toml model.h5 -o response.h5. `threads` 0: as [simulate] says.
void simulate(const StageArguments& arguments, int threads);

}  // namespace tiprub
