// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/stage.h"

#include <functional>
#include <optional>

#include "cases/program/output_file.h"
#include "mesh/import/sector_import.h"
#include "mesh/sector/sector_check.h"
#include "mesh/sector/sector_file.h"
#include "mesh/sector/sector_mesher.h"

namespace tiprub::mesh {

namespace {

/// Writes a mesh that is made and checked already.
using Writer = std::function<void(const std::filesystem::path&)>;

/// The sector is checked in memory, because an inverted element shows only there.
Writer mesh_wheel(const StageArguments& arguments, CaseTable& table) {
  const Wheel wheel = read_wheel(table);
  if (arguments.verbosity == Verbosity::verbose) say(arguments, table.resolved());
  const MeshedSector mesh = mesh_sector(wheel);
  say(arguments, describe(measure_sector(mesh, wheel), mesh, wheel));
  return [mesh](const std::filesystem::path& path) { write_sector(mesh, path); };
}

Writer import_mesh(const StageArguments& arguments, CaseTable& table) {
  const ImportParameters parameters = read_import_parameters(table);
  if (arguments.verbosity == Verbosity::verbose) say(arguments, table.resolved());
  const ImportedSector sector = import_sector(parameters);
  say(arguments, sector.description);
  return [sector](const std::filesystem::path& path) { write_mesh(sector.mesh, path); };
}

/// The file given by --import replaces [mesh] mesh_file.
std::vector<std::string> settings_of(const StageArguments& arguments, const std::string& import) {
  std::vector<std::string> settings = arguments.settings;
  if (!import.empty()) settings.push_back("mesh.mesh_file='" + std::filesystem::absolute(import).string() + "'");
  return settings;
}

}  // namespace

std::string mesh_tables(const CaseFile& file) {
  return file.resolved("mesh", [](CaseTable& table) {
    if (is_import(table))
      read_import_parameters(table);
    else
      read_wheel(table);
  });
}

void run_mesh(const StageArguments& arguments, const std::string& import) {
  CaseTable table = CaseFile(arguments.inputs[0], settings_of(arguments, import)).table("mesh");
  std::optional<OutputLock> lock;
  if (arguments.action == Action::run) lock.emplace(arguments.output);
  const Writer write = is_import(table) ? import_mesh(arguments, table) : mesh_wheel(arguments, table);
  if (arguments.action == Action::check) return;
  OutputFile output(arguments.output);
  write(output.scratch());
  output.commit();
  say(arguments, "wrote " + arguments.output.string());
}

}  // namespace tiprub::mesh
