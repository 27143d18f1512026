// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>

#include "mesh/stage.h"

int main(int argc, char** argv) {
  tiprub::mesh::MeshOptions options;
  const tiprub::Stage stage{
      .name = "tiprub-mesh",
      .summary = "Meshes one sector of a wheel with quadratic elements, or imports a mesh of another code.",
      .inputs = {{"case.toml", "the scene; only its table [mesh] is read"}},
      .output = "sector.msh",
      .tables = tiprub::mesh::mesh_tables,
      .add_options = [&](CLI::App& app) {
        app.add_option(
            "--import", options.import,
            "import this mesh (.inp, .bdf, .cdb, .unv or .msh), as [mesh] mesh_file does; [mesh] selects its groups");
        app.add_option("--picture", options.picture,
                       "also draw the mesh with its groups, as SVG; with --check this is all that is written");
      }};
  return tiprub::run_stage(argc, argv, stage, [&](const tiprub::StageArguments& arguments) {
    tiprub::mesh::run_mesh(arguments, options);
  });
}
