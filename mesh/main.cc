// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/case_file.h"
#include "cases/program/command_line.h"
#include "cases/program/output_file.h"
#include "mesh/sector/sector_check.h"
#include "mesh/sector/sector_file.h"
#include "mesh/sector/sector_mesher.h"

namespace {

using namespace tiprub;

void run(const StageArguments& arguments) {
  CaseTable table = CaseFile(arguments.inputs[0], arguments.settings).table("mesh");
  const Wheel wheel = read_wheel(table);
  if (arguments.verbosity == Verbosity::verbose) say(arguments, table.resolved());
  const MeshedSector mesh = mesh_sector(wheel);
  const SectorReport report = measure_sector(mesh, wheel);
  say(arguments, describe(report, mesh, wheel));
  if (arguments.action == Action::check) return;
  OutputFile output(arguments.output);
  write_sector(mesh, output.scratch());
  output.commit();
  say(arguments, "wrote " + arguments.output.string());
}

}  // namespace

int main(int argc, char** argv) {
  const Stage stage{.name = "tiprub-mesh",
                    .summary = "Meshes one sector of a wheel with quadratic hexahedra.",
                    .inputs = {{"case.toml", "the scene; only its table [mesh] is read"}},
                    .output = "sector.msh"};
  return run_stage(argc, argv, stage, run);
}
