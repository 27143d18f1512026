// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"

namespace tiprub::simulate {

/// The tables of the case that are read, [casing] and [simulate], with defaults.
std::string simulate_tables(const CaseFile& file);

/// tiprub-simulate case.toml model.h5 -o response.h5. `threads` 0: as [simulate] says.
void run_simulate(const StageArguments& arguments, int threads);

}  // namespace tiprub::simulate
