// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/readers.h"

#include <fstream>
#include <stdexcept>

#include "cases/program/case_file.h"
#include "mesh/blades/curve_files.h"
#include "mesh/blades/meanline_file.h"
#include "mesh/blades/section_surface.h"
#include "mesh/blades/section_table.h"
#include "mesh/wheels/wheel.h"
#include "postprocess/analysis/material_strength.h"
#include "postprocess/analysis/postprocess_parameters.h"
#include "postprocess/postprocess.h"
#include "reduce/model/fields_file.h"
#include "reduce/reducing.h"
#include "reduce/sector/reduction_parameters.h"
#include "simulate/response/response_file.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/simulate_parameters.h"
#include "simulate/simulation.h"

namespace fs = std::filesystem;

namespace tiprub::fuzz {

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
  return {inputs, "output", {}, Verbosity::quiet, Action::check};
}

void read_mesh(const fs::path& file, const fs::path& beside) {
  reduce_case(check({beside / "case.toml", file}), {});
}

void read_model_file(const fs::path& file, const fs::path& beside) {
  simulate(check({beside / "case.toml", file}), 1);
}

void read_fields(const fs::path& file, const fs::path&) {
  const FieldsReader fields(file);
  for (int n = 0; n <= fields.sector().sector_count / 2; ++n)
    fields.expand(n, Eigen::MatrixXcd::Ones(fields.dofs(n), 1));
}

void check_report_of_fields(const fs::path& file, const fs::path& beside) {
  postprocess(check({beside / "case.toml", beside / "model.h5", beside / "response.h5"}), file);
}

void read_response_file(const fs::path& file, const fs::path&) {
  read_response_key(file);
  read_end_state(file);
}

void check_report(const fs::path& file, const fs::path& beside) {
  postprocess(check({beside / "case.toml", beside / "model.h5", file}), {});
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

const std::vector<Reader> readers = {
    {"case",
     ".toml",
     Format::text,
     {table("mesh", read_wheel), table("reduce", read_reduction_parameters), table("casing", read_casing),
      table("simulate", read_simulate_parameters), table("postprocess", read_postprocess_parameters), read_material}},
    {"sections", ".txt", Format::text, {read_sections}},
    {"profile", ".curve", Format::text, {read_curves, read_path}},
    {"meanline", ".rtzt", Format::text, {read_meanline_file}},
    {"mesh", ".msh", Format::mesh, {read_mesh}},
    {"model", ".h5", Format::hdf5, {read_model_file}},
    {"fields", ".h5", Format::hdf5, {read_fields, check_report_of_fields}},
    {"response", ".h5", Format::hdf5, {read_response_file, check_report}},
};

}  // namespace

const Reader& reader(const std::string& name) {
  for (const Reader& one : readers)
    if (one.name == name) return one;
  throw std::out_of_range("no reader " + name +
                          "; there are: case, sections, profile, meanline, mesh, model, fields, response");
}

}  // namespace tiprub::fuzz
