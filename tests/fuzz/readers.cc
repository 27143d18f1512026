// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/readers.h"

#include <fstream>
#include <stdexcept>

#include "cases/program/case_file.h"
#include "mesh/blades/blade_files.h"
#include "mesh/blades/blade_section.h"
#include "mesh/import/sector_import.h"
#include "mesh/wheels/wheel.h"
#include "postprocess/analysis/postprocess_parameters.h"
#include "postprocess/stage.h"
#include "reduce/matrices/matrix_sector.h"
#include "reduce/model/fields_file.h"
#include "reduce/sector/reduction_parameters.h"
#include "reduce/stage.h"
#include "simulate/response/response_file.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/damping.h"
#include "simulate/scene/simulate_parameters.h"
#include "simulate/stage.h"

namespace fs = std::filesystem;

namespace tiprub::fuzz {
using namespace mesh;
using namespace reduce;
using namespace simulate;
using namespace postprocess;

namespace {

/// Reads one table, if the case has it.
template <class Read>
Reader::Part table(const std::string& name, const Read& read) {
  return [=](const fs::path& file, const fs::path&) {
    const CaseFile scene(file);
    if (!scene.has(name)) return;
    CaseTable values = scene.table(name);
    read(values);
  };
}

void read_material(const fs::path& file, const fs::path&) {
  read_material_strength(CaseFile(file));
}

/// What a stage does with --check.
StageArguments check(const std::vector<fs::path>& inputs) {
  StageArguments arguments;
  arguments.inputs = inputs;
  arguments.output = "output";
  arguments.verbosity = Verbosity::quiet;
  arguments.action = Action::check;
  return arguments;
}

void read_mesh(const fs::path& file, const fs::path& beside) {
  run_reduce(check({beside / "case.toml", file}), {});
}

void read_model_file(const fs::path& file, const fs::path& beside) {
  run_simulate(check({beside / "case.toml", file}), 1);
}

void read_fields(const fs::path& file, const fs::path&) {
  const FieldsReader fields(file);
  for (int n = 0; n <= fields.sector().sector_count / 2; ++n)
    fields.expand(n, Eigen::MatrixXcd::Ones(fields.dofs(n), 1));
}

void check_report_of_fields(const fs::path& file, const fs::path& beside) {
  run_postprocess(check({beside / "case.toml", beside / "model.h5", beside / "response.h5"}),
                  {.fields_file = file, .budget_fields = {}, .compared = {}, .runs = {}});
}

void read_response_file(const fs::path& file, const fs::path&) {
  read_response_key(file);
  read_end_state(file);
}

void check_report(const fs::path& file, const fs::path& beside) {
  run_postprocess(check({beside / "case.toml", beside / "model.h5", file}), {});
}

NamedText text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {path.string(), std::string(std::istreambuf_iterator<char>(file), {})};
}

void shape(const FileBlade& blade) {
  SectionSurface(blade.sections, 0.01).at(0.5, 0.5);
}

void read_sections(const fs::path& file, const fs::path&) {
  shape(read_section_table(text_of(file), {1.0, 1.0}));
}

void read_curves(const fs::path& file, const fs::path&) {
  const MeridionalPath hub = {{-1.0, 0.11}, {1.0, 0.11}}, shroud = {{-1.0, 0.13}, {1.0, 0.13}};
  shape(cut_to_path(read_profile_curve(text_of(file), 1.0, hub), hub, shroud, 0.0, file.string(), "hub.curve"));
}

void read_path(const fs::path& file, const fs::path&) {
  nearest_on(read_path_curve(text_of(file), 1.0), {0.0, 0.1});
}

void read_meanline_file(const fs::path& file, const fs::path&) {
  shape(read_meanline(text_of(file), 1.0));
}

void read_profile(const fs::path& file, const fs::path&) {
  const CasingProfile profile = read_casing_profile(text_of(file), 2.0);
  for (const double angle : {-1.0, 0.0, 0.7, 1.999}) profile(angle, 0.3);
}

/// The file in place of a list of pairs, as [simulate] damping_table takes it.
void read_pairs(const fs::path& file, const fs::path& beside) {
  const std::string setting = "simulate.damping_table = '" + fs::absolute(file).string() + "'";
  CaseTable table = CaseFile(beside / "case.toml", {setting}).table("simulate");
  read_damping(table).ratio(0, 0, 1000.0);
}

/// With selections that don't fit every damaged mesh, too.
template <ReadMesh read>
void read_foreign_mesh(const fs::path& file, const fs::path&) {
  ImportParameters parameters;
  parameters.file = text_of(file);
  parameters.read = read;
  parameters.length = 1e-3;
  parameters.selection = {{"clamped", "plane x 0.04"}, {"blade_tip", "normal 1 0 0"}};
  import_sector(parameters);
  const char* const key = read == read_msh ? "blade_tip" : "contact";
  const char* const set = read == read_bdf ? "SET 7" : read == read_cdb ? "CONTACT" : key;
  parameters.selection = {{"clamped", "plane x 0.04"}, {key, set}};
  import_sector(parameters);
  parameters.sector_count = 6;
  try {
    import_sector(parameters);
  } catch (const InputError&) {  // a block has no cuts that a sixth of a turn brings together
  }
}

/// The file in the place of one of those that give a sector by its matrices.
template <fs::path MatrixFiles::*place>
void read_matrices(const fs::path& file, const fs::path& beside) {
  constexpr double tolerance = 1e-6;
  MatrixFiles files = {beside / "stiffness.mtx", beside / "mass.mtx", beside / "nodes.csv", beside / "rows.dof", {}};
  files.*place = file;
  read_matrix_sector(files, tolerance);
}

/// As K at a further speed; without a list of dofs the rows are the nodes' in their order.
void read_further_stiffness(const fs::path& file, const fs::path& beside) {
  constexpr double tolerance = 1e-6, speed = 100;
  read_matrix_sector({beside / "stiffness.mtx", beside / "mass.mtx", beside / "nodes.csv", {}, {{speed, file}}},
                     tolerance);
}

const std::vector<Reader> readers = {
    {"case",
     ".toml",
     Format::text,
     {table("mesh", read_wheel),
      table("reduce", [](CaseTable& values) { read_reduction_parameters(values, SectorInput::mesh); }),
      table("casing", read_casing), table("simulate", read_simulate_parameters),
      table("postprocess", read_postprocess_parameters), read_material}},
    {"sections", ".txt", Format::text, {read_sections}},
    {"profile", ".curve", Format::text, {read_curves, read_path}},
    {"meanline", ".rtzt", Format::text, {read_meanline_file}},
    {"casing", ".csv", Format::text, {read_profile}},
    {"pairs", ".csv", Format::text, {read_pairs}},
    {"stiffness", ".mtx", Format::text, {read_matrices<&MatrixFiles::stiffness>, read_further_stiffness}},
    {"mass", ".mtx", Format::text, {read_matrices<&MatrixFiles::mass>}},
    {"nodes", ".csv", Format::text, {read_matrices<&MatrixFiles::nodes>}},
    {"rows", ".dof", Format::text, {read_matrices<&MatrixFiles::dofs>}},
    {"inp", ".inp", Format::text, {read_foreign_mesh<read_inp>}},
    {"bdf", ".bdf", Format::text, {read_foreign_mesh<read_bdf>}},
    {"cdb", ".cdb", Format::text, {read_foreign_mesh<read_cdb>}},
    {"unv", ".unv", Format::text, {read_foreign_mesh<read_unv>}},
    {"msh", ".msh", Format::mesh, {read_foreign_mesh<read_msh>}},
    {"mesh", ".msh", Format::mesh, {read_mesh}},
    {"model", ".h5", Format::hdf5, {read_model_file}},
    {"fields", ".h5", Format::hdf5, {read_fields, check_report_of_fields}},
    {"response", ".h5", Format::hdf5, {read_response_file, check_report}},
};

}  // namespace

const Reader& reader_named(const std::string& name) {
  for (const Reader& one : readers)
    if (one.name == name) return one;
  throw std::out_of_range("no reader " + name +
                          "; there are: case, sections, profile, meanline, casing, pairs, stiffness, mass, nodes, "
                          "rows, inp, bdf, cdb, unv, msh, mesh, model, fields, response");
}

}  // namespace tiprub::fuzz
