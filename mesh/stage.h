// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"

namespace tiprub::mesh {

/// The table that this stage reads from the case, [mesh], with all its values.
std::string mesh_tables(const CaseFile& file);

/// tiprub-mesh case.toml -o sector.msh. `import`: a mesh of another code in place of [mesh] mesh_file, or empty.
void run_mesh(const StageArguments& arguments, const std::string& import);

}  // namespace tiprub::mesh
