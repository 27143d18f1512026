// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"

namespace tiprub {

/// What is read of the case: [mesh].
std::string mesh_tables(const CaseFile& file);

/// tiprub-mesh case.toml -o sector.msh.
void mesh_case(const StageArguments& arguments);

}  // namespace tiprub
