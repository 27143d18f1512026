// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>

#include "cases/program/command_line.h"
#include "cases/program/machine.h"
#include "reduce/stage.h"

int main(int argc, char** argv) {
  tiprub::return_freed_memory();
  tiprub::prepare_blas(argv);
  tiprub::reduce::ReduceOptions options;
  tiprub::Stage stage;
  stage.name = "tiprub-reduce";
  stage.summary = "Reduces a sector of a wheel to a small model of the wheel that is valid over a range of speeds.";
  stage.inputs = {{"case.toml", "the scene; its table [reduce] is read"},
                  {"sector.msh", "one sector of the wheel", true}};
  stage.output = "model.h5";
  stage.tables = [&](const tiprub::CaseFile& file) { return tiprub::reduce::reduce_tables(file, options.input()); };
  stage.add_options = [&](CLI::App& app) {
    app.add_option("--export-ccx", options.calculix_folder,
                   "write the sector as CalculiX decks, one for each verification speed, into this folder, and stop");
    app.add_option("--modes", options.modes_file,
                   "write modes and static state of the unreduced sector at the verification speeds to this file "
                   "and to stdout, and stop");
    app.add_option("--export-matrix-market", options.matrix_market_folder,
                   "also write the model's matrices in Matrix Market format into this folder");
    app.add_option("--fields", options.fields_file,
                   "also write the basis on all nodes to this file (fields.h5), for displacement and stress of "
                   "the whole wheel");
    app.add_option(
           "--matrices", options.matrices,
           "K, M (Matrix Market, or CalculiX's .sti and .mas) and nodes.csv of a sector in place of sector.msh")
        ->expected(3);
    app.add_option("--threads", options.threads, "number of threads; 0: as [reduce] says")->check(CLI::Range(0, 256));
    app.add_option("--matrix-dofs", options.matrix_dofs, "list of the matrices' rows (CalculiX's .dof)");
    app.add_option("--matrix-at", options.matrices_at,
                   "a further speed in rpm, and the file of K at this speed; may be repeated")
        ->expected(2, 4);
  };
  return tiprub::run_stage(argc, argv, stage, [&](const tiprub::StageArguments& arguments) {
    tiprub::reduce::run_reduce(arguments, options);
  });
}
