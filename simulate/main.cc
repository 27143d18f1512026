// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>

#include "cases/program/command_line.h"
#include "cases/program/machine.h"
#include "simulate/stage.h"

int main(int argc, char** argv) {
  tiprub::prepare_blas(argv);
  int threads = 0;
  tiprub::Stage stage;
  stage.name = "tiprub-simulate";
  stage.summary = "Computes the settled motion of a reduced rotor in contact with a rigid casing, speed by speed.";
  stage.inputs = {{"case.toml", "the scene; its tables [casing] and [simulate] are read"},
                  {"model.h5", "the reduced rotor"}};
  stage.output = "response.h5";
  stage.tables = tiprub::simulate::simulate_tables;
  stage.add_options = [&](CLI::App& app) {
    app.add_option("--threads", threads, "number of threads that share the speeds; 0: as [simulate] says")
        ->check(CLI::Range(0, 1024));
  };
  return tiprub::run_stage(argc, argv, stage, [&](const tiprub::StageArguments& arguments) {
    tiprub::simulate::run_simulate(arguments, threads);
  });
}
