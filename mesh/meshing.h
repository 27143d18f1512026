// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/program/command_line.h"

namespace tiprub {

/// tiprub-mesh case.toml -o sector.msh.
void mesh_case(const StageArguments& arguments);

}  // namespace tiprub
