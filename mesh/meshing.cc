// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/meshing.h"

#include <optional>

#include "cases/program/output_file.h"
#include "cases/program/output_lock.h"
#include "mesh/sector/sector_check.h"
#include "mesh/sector/sector_file.h"
#include "mesh/sector/sector_mesher.h"

namespace tiprub {

namespace {

Wheel read(const StageArguments& arguments) {
  CaseTable table = CaseFile(arguments.inputs[0], arguments.settings).table("mesh");
  Wheel wheel = read_wheel(table);
  if (arguments.verbosity == Verbosity::verbose) say(arguments, table.resolved());
  return wheel;
}

/// Of the sector in memory: an inverted element shows only there.
void check(const StageArguments& arguments, const MeshedSector& mesh, const Wheel& wheel) {
  const SectorReport report = measure_sector(mesh, wheel);
  say(arguments, describe(report, mesh, wheel));
}

void write(const StageArguments& arguments, const MeshedSector& mesh) {
  OutputFile output(arguments.output);
  write_sector(mesh, output.scratch());
  output.commit();
}

void report(const StageArguments& arguments) {
  say(arguments, "wrote " + arguments.output.string());
}

}  // namespace

std::string mesh_tables(const CaseFile& file) {
  return file.resolved("mesh", read_wheel);
}

void mesh_case(const StageArguments& arguments) {
  const Wheel wheel = read(arguments);
  std::optional<OutputLock> lock;
  if (arguments.action == Action::run) lock.emplace(arguments.output);
  const MeshedSector mesh = mesh_sector(wheel);
  check(arguments, mesh, wheel);
  if (arguments.action == Action::check) return;
  write(arguments, mesh);
  report(arguments);
}

}  // namespace tiprub
