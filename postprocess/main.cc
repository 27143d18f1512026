// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>

#include "cases/program/command_line.h"
#include "cases/program/machine.h"
#include "postprocess/stage.h"

int main(int argc, char** argv) {
  tiprub::keep_freed_memory();
  tiprub::prepare_blas(argv);
  tiprub::postprocess::PostprocessOptions options;
  tiprub::Stage stage;
  stage.name = "tiprub-postprocess";
  stage.summary = "Writes a report of a response: critical speeds, interaction maps, contact maps and stresses.";
  stage.inputs = {{"case.toml", "the scene; [postprocess] is read"},
                  {"model.h5", "the reduced rotor, from tiprub-reduce"},
                  {"response.h5", "the response, from tiprub-simulate"}};
  stage.output = "report";
  stage.tables = tiprub::postprocess::postprocess_tables;
  stage.add_options = [&](CLI::App& app) {
    app.add_option(
        "--fields", options.fields_file,
        "full fields, from tiprub-reduce --fields: adds displacement and stress on the whole wheel, and the "
        "stress at every critical speed");
    app.add_option("--budget-fields", options.budget_fields,
                   "full fields of [simulate] budget_model: adds the stress that this model has to the error budgets")
        ->needs("--fields");
    app.add_option("--compare", options.compared,
                   "another report's folder, or another response of this model, whose response, maps and critical "
                   "speeds are shown beside these; may be repeated")
        ->allow_extra_args(false);
    app.add_option("--runs", options.runs,
                   "file that another program wrote with --times, for the page; may be repeated")
        ->allow_extra_args(false);
  };
  return tiprub::run_stage(argc, argv, stage, [&](const tiprub::StageArguments& arguments) {
    tiprub::postprocess::run_postprocess(arguments, options);
  });
}
