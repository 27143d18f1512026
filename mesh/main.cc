// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"
#include "cases/program/errors.h"
#include "cases/program/output_file.h"
#include "cases/program/text.h"
#include "mesh/cells/gmsh_file.h"
#include "mesh/import/sector_import.h"
#include "mesh/sector/sector_check.h"
#include "mesh/sector/sector_file.h"
#include "mesh/sector/sector_mesher.h"

namespace tiprub::mesh {

namespace {

/// What the command line adds to the options of all stages.
struct MeshOptions {
  std::string import;             ///< a mesh of another code in place of [mesh] mesh_file; may be empty
  std::filesystem::path picture;  ///< where to draw the mesh (.svg); empty: not at all
};

/// To be called when the table has been read, before the work.
void after_reading(const StageArguments& arguments, const MeshOptions& options, const CaseTable& table) {
  refuse_overwriting({options.picture, arguments.output}, table.files());
  if (arguments.verbosity == Verbosity::verbose) say(arguments, table.resolved());
}

/// The sector is checked in memory, because an inverted element shows only there.
NamedMesh mesh_wheel(const StageArguments& arguments, const MeshOptions& options, CaseTable& table) {
  const Wheel wheel = read_wheel(table);
  after_reading(arguments, options, table);
  const MeshedSector mesh = mesh_sector(wheel);
  say(arguments, describe(measure_sector(mesh, wheel), mesh, wheel));
  return named_groups(mesh);
}

NamedMesh import_mesh(const StageArguments& arguments, const MeshOptions& options, CaseTable& table) {
  const ImportParameters parameters = read_import_parameters(table);
  after_reading(arguments, options, table);
  ImportedSector sector = import_sector(parameters);
  require_usual_radius(table, parameters, sector.largest_radius);
  say(arguments, sector.description);
  return std::move(sector.mesh);
}

/// The file given by --import replaces [mesh] mesh_file.
std::vector<std::string> settings_of(const StageArguments& arguments, const std::string& import) {
  std::vector<std::string> settings = arguments.settings;
  if (!import.empty()) settings.push_back("mesh.mesh_file=" + in_quotes(std::filesystem::absolute(import).string()));
  return settings;
}

/// [mesh] is absent if a user has a mesh or a model, so that the message names the place of these.
CaseTable mesh_table(const CaseFile& file) {
  try {
    return file.table("mesh");
  } catch (const InputError& error) {
    if (file.has("mesh")) throw;
    throw InputError(std::string(error.what()) +
                     ", or name your own mesh for tiprub-reduce by MESH := wheel.msh, or your own model by MODEL := "
                     "wheel.h5, in the Makefile of the case, which then needs no [mesh]");
  }
}

void require_ending(const std::string& option, const std::filesystem::path& path, const char* ending) {
  if (path.extension() != ending) throw InputError(option + " " + path.string() + ": must end in " + ending);
}

/// The keys that made a mesh, by which tiprub-reduce recognises that it is of another case. A mesh_file may be named
/// on the command line of this stage alone.
std::string keys_of_mesh(const CaseFile& file) {
  std::string lines;
  for (const auto& [key, value] : written_keys(file.source()))
    if (key.starts_with("mesh.") && key != "mesh.mesh_file") lines += key + " = " + value + "\n";
  return lines;
}

void draw(const StageArguments& arguments, const NamedMesh& mesh, const std::filesystem::path& path) {
  OutputFile output(path);
  write_file(output.scratch(), [&](std::ostream& file) { file << picture_of(mesh); });
  output.commit();
  say(arguments, "drew " + path.string());
}

/// The table that this stage reads from the case, [mesh], with all its values.
std::string mesh_tables(const CaseFile& file) {
  mesh_table(file);
  return file.resolved("mesh", [](CaseTable& table) {
    if (is_import(table))
      read_import_parameters(table);
    else
      read_wheel(table);
  });
}

/// tiprub-mesh case.toml -o sector.msh.
void run_mesh(const StageArguments& arguments, const MeshOptions& options) {
  require_ending("-o", arguments.output, ".msh");  // by the ending gmsh chooses the format
  if (!options.picture.empty()) require_ending("--picture", options.picture, ".svg");
  refuse_overwriting({options.picture, arguments.output}, arguments.inputs);
  const CaseFile case_file(arguments.inputs[0], settings_of(arguments, options.import));
  CaseTable table = mesh_table(case_file);
  std::optional<OutputLock> lock;
  if (arguments.action == Action::run) lock.emplace(arguments.output);
  const NamedMesh mesh =
      is_import(table) ? import_mesh(arguments, options, table) : mesh_wheel(arguments, options, table);
  if (!options.picture.empty()) draw(arguments, mesh, options.picture);
  if (arguments.action == Action::check) return;
  OutputFile output(arguments.output);
  write_mesh(mesh, output.scratch());
  append_comments(keys_of_mesh(case_file), output.scratch());
  output.commit();
  say(arguments, "wrote " + arguments.output.string());
}

}  // namespace

}  // namespace tiprub::mesh

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
