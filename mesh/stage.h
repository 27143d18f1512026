// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"

namespace tiprub::mesh {

/// The table that this stage reads from the case, [mesh], with all its values.
std::string mesh_tables(const CaseFile& file);

/// What the command line adds to the options of all stages.
struct MeshOptions {
  std::string import;             ///< a mesh of another code in place of [mesh] mesh_file; may be empty
  std::filesystem::path picture;  ///< where to draw the mesh (.svg); empty: not at all
};

/// tiprub-mesh case.toml -o sector.msh.
void run_mesh(const StageArguments& arguments, const MeshOptions& options);

}  // namespace tiprub::mesh
