// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>

#include "cases/program/errors.h"
#include "tests/benchmark/benchmarks.h"
#include "tests/benchmark/growth.h"

/// tiprub-benchmark [steps | sweep | accuracy | schemes | stability | growth | orbits | scaling] [--model model.h5]
/// [--speeds 20]
int main(int argc, char** argv) {
  CLI::App app{"What the march in time costs, and what accuracy costs."};
  std::string what = "steps", model;
  int speeds = 20, lobes = 2;
  app.add_option("what", what, "steps, sweep, accuracy, schemes, stability, growth, orbits or scaling")
      ->check(CLI::IsMember({"steps", "sweep", "accuracy", "schemes", "stability", "growth", "orbits", "scaling"}));
  app.add_option("--speeds", speeds, "of sweep, schemes and orbits")->check(CLI::PositiveNumber);
  app.add_option("--lobes", lobes, "of orbits")->check(CLI::PositiveNumber);
  app.add_option("--model", model, "a model.h5; without it, a made-up wheel of 900 dofs");
  CLI11_PARSE(app, argc, argv);
  try {
    if (what == "steps") tiprub::simulate::testing::print_step_costs(model);
    if (what == "sweep") tiprub::simulate::testing::print_sweep_cost(model, speeds);
    if (what == "accuracy") tiprub::simulate::testing::print_accuracy(model);
    if (what == "schemes" && !tiprub::simulate::testing::print_scheme_agreement(model, speeds)) return 1;
    if (what == "orbits") tiprub::simulate::testing::print_orbit_cost(model, lobes, speeds);
    if (what == "growth") tiprub::simulate::testing::print_growth();
    if (what == "scaling") tiprub::simulate::testing::print_scaling();
    if (what == "stability") tiprub::simulate::testing::print_stability(model);
  } catch (const tiprub::RunError& error) {
    std::fprintf(stderr, "tiprub-benchmark: error: %s\n", error.what());
    return 1;
  }
  return 0;
}
