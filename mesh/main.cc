// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/meshing.h"

int main(int argc, char** argv) {
  const tiprub::Stage stage{.name = "tiprub-mesh",
                            .summary = "Meshes one sector of a wheel with quadratic hexahedra.",
                            .inputs = {{"case.toml", "the scene; only its table [mesh] is read"}},
                            .output = "sector.msh",
                            .tables = tiprub::mesh_tables};
  return tiprub::run_stage(argc, argv, stage, tiprub::mesh_case);
}
