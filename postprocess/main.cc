// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"
#include "cases/program/output_file.h"
#include "cases/program/progress.h"
#include "postprocess/figures/field_figures.h"
#include "postprocess/report/exactness.h"
#include "postprocess/report/report.h"
#include "postprocess/report/result_tables.h"
#include "postprocess/report/verdict.h"
#include "postprocess/tables/interruption.h"
#include "reduce/model/reduced_model_file.h"
#include "simulate/response/response_file.h"

namespace fs = std::filesystem;

namespace {

using namespace tiprub;

struct Inputs {
  ReportSource source;
  PostprocessParameters parameters;
  ReducedModel model;
  Response response;
};

Inputs read_inputs(const StageArguments& arguments) {
  const CaseFile file(arguments.inputs[0], arguments.settings);
  CaseTable table = file.table("postprocess");
  Inputs inputs;
  inputs.parameters = read_postprocess_parameters(table);
  if (arguments.verbosity == Verbosity::verbose) say(arguments, "[postprocess]\n" + table.resolved());
  inputs.source = {file.title(), file.source()};
  inputs.model = read_model(arguments.inputs[1]);
  inputs.response = read_response(arguments.inputs[2]);
  check_together(inputs.model, inputs.response, arguments.inputs[2].string());
  require_gnuplot();
  return inputs;
}

/// Pictures and VTU files of the whole wheel and the stress at the critical speeds, if there are full fields to make
/// them from; a line about it for the page.
std::string add_fields(Study& study, const fs::path& fields_file, const fs::path& folder,
                       std::vector<Figure>& figures) {
  const std::string what = "displacement and stress on the whole wheel: ";
  if (fields_file.empty()) return what + "left out, no fields.h5 was given (--fields)";
  const FieldStudy fields = recover_fields(fields_file, study);
  write_vtu_files(fields, folder / "fields");
  note_stresses(fields, study.critical);
  for (Figure& figure : field_figures(fields)) figures.push_back(std::move(figure));
  return what + (fields.has_instant ? "at the sample with the largest contact force, by linear elasticity"
                                    : "modes only, the response holds no state of the rotor; simulate it again");
}

/// Returns how many figures there are.
std::size_t write_report(Study& study, const ReportSource& source, const fs::path& fields_file,
                         const fs::path& folder, Progress::Shown shown) {
  fs::create_directories(folder / "figures");
  std::vector<Figure> figures = all_figures(study);
  study.response.scene.scope += "\n" + add_fields(study, fields_file, folder, figures);
  {
    Progress progress("drawing", figures.size(), shown);
    draw_figures(figures, folder / "figures", [&] { progress.advance(); });
  }
  write_csv(critical_speed_record(study), folder / "critical_speeds.csv");
  write_text(aligned_text(critical_speed_summary(study)), folder / "critical_speeds.txt");
  write_csv(linear_criterion_record(study), folder / "linear_criterion.csv");
  write_csv(speed_record(study), folder / "speeds.csv");
  write_csv(exactness_record(study), folder / "exactness.csv");
  write_csv(drift_record(study), folder / "contact_drift.csv");
  if (!study.sweeps.empty()) write_csv(sweep_record(study), folder / "sweeps.csv");
  write_text(source.case_text, folder / "case.toml");
  write_text(report_page(study, source, figures, folder), folder / "report.html");
  return figures.size();
}

void postprocess(const StageArguments& arguments, const fs::path& fields_file) {
  Inputs inputs = read_inputs(arguments);
  if (arguments.action == Action::check) {
    if (!fields_file.empty()) check_fields(fields_file, inputs.model);
    return;
  }
  OutputFile output(arguments.output);
  note_interruptions();
  Study study = make_study(inputs.parameters, std::move(inputs.model), std::move(inputs.response));
  const auto beside_case = [&](const std::string& name) {
    return name.empty() ? fs::path() : arguments.inputs[0].parent_path() / name;
  };
  study.sweeps =
      compare_sweeps(study.response, study.model.contact, study.map_node, study.parameters.component,
                     beside_case(study.parameters.response_up), beside_case(study.parameters.response_down));
  const std::size_t figure_count =
      write_report(study, inputs.source, fields_file, output.scratch(),
                   arguments.verbosity == Verbosity::quiet ? Progress::Shown::never : Progress::Shown::on_a_terminal);
  stop_if_interrupted();
  output.commit();
  std::printf("%s", aligned_text(critical_speed_summary(study)).c_str());
  std::fflush(stdout);
  if (arguments.verbosity == Verbosity::verbose)
    for (const std::string& line : verdict(study)) say(arguments, line);
  say(arguments, (arguments.output / "report.html").lexically_normal().string() + ": " +
                     std::to_string(study.critical.size()) + " critical speeds, " +
                     std::to_string(study.response.speeds.size()) + " speeds, " + std::to_string(figure_count) +
                     " figures");
}

}  // namespace

int main(int argc, char** argv) {
  std::string fields_file;
  Stage stage{
      .name = "tiprub-postprocess",
      .summary = "Draws what a rub simulation found: interaction maps, contact maps, critical speeds, a report.",
      .inputs = {{"case.toml", "the scene; [postprocess] is read"},
                 {"model.h5", "the reduced rotor, from tiprub-reduce"},
                 {"response.h5", "the response, from tiprub-simulate"}},
      .output = "report",
      .add_options = [&](CLI::App& app) {
        app.add_option(
            "--fields", fields_file,
            "full fields, from tiprub-reduce --fields: adds displacement and stress on the whole wheel, and "
            "the stress at every critical speed");
      }};
  const auto body = [&](const StageArguments& arguments) {
    try {
      postprocess(arguments, fields_file);
    } catch (const Interrupted&) {  // everything is cleaned up; leave as the other stages do
      constexpr int exit_by_signal = 128;
      std::_Exit(exit_by_signal + interruption());
    }
  };
  return run_stage(argc, argv, stage, body);
}
