// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>

#include "simulate/speed_audit.h"
#include "simulate/speed_run.h"
#include "tests/benchmark/benchmarks.h"

namespace tiprub::bench {

namespace {

constexpr double inaccurate = 5e-2;  // relative error from which on a stable run is of no use
constexpr int samples = 240, reference_steps = 9600;

SpeedResponse run(const BenchWheel& wheel, SimulateParameters parameters) {
  parameters.damping_ratios = {wheel.damping};
  parameters.samples_per_revolution = samples;
  parameters.recorded_revolutions = 6;
  parameters.min_revolutions = 20;
  parameters.max_revolutions = 60;
  parameters.settle_tolerance = 1e-4;
  parameters.casing_areas = 1;
  const SceneScope scope = find_scope(wheel.model.sector_count, wheel.casing.lobes, parameters);
  return simulate_speed({wheel.model, wheel.casing, parameters, scope}, wheel.speed).response;
}

const char* verdict(const SpeedResponse& at, const SpeedResponse& reference) {
  if (at.failure.find("grew beyond") != std::string::npos) return "blown_up";
  if (!at.failure.empty()) return "refused";
  return difference(at, reference).value > inaccurate ? "inaccurate" : "stable";
}

}  // namespace

void print_stability(const std::string& model) {
  const BenchWheel wheel = model.empty() ? made_wheel(2) : given_wheel(model, 2);
  SimulateParameters fine;
  fine.steps_per_revolution = reference_steps;
  const SpeedResponse reference = run(wheel, fine);
  std::printf("# %s at %.1f rad/s\n# row\tname\tsteps a revolution\tverdict\n", wheel.name.c_str(), wheel.speed);
  struct Row {
    const char* name;
    Scheme scheme;
    ContactRule contact = ContactRule::complementarity;
    int modes = 0;
    double penalty = 0;
  };
  const Row rows[] = {
      {"trigonometric", Scheme::trigonometric},
      {"residual_flexibility_20", Scheme::residual_flexibility, ContactRule::complementarity, 20},
      {"moreau_jean", Scheme::moreau_jean},
      {"central_differences", Scheme::central_differences},
      {"paper", Scheme::central_differences, ContactRule::paper},
      {"penalty_10", Scheme::penalty, ContactRule::complementarity, 0, 10},
      {"penalty_100", Scheme::penalty, ContactRule::complementarity, 0, 100},
      {"penalty_1000", Scheme::penalty, ContactRule::complementarity, 0, 1000},
      {"trigonometric_8_modes", Scheme::trigonometric, ContactRule::complementarity, 8},
      {"trigonometric_40_modes", Scheme::trigonometric, ContactRule::complementarity, 40},
  };
  int number = 0;
  for (const Row& row : rows) {
    for (int steps : {240, 480, 960, 1920, 3840, 7680, 15360}) {
      SimulateParameters parameters;
      parameters.scheme = row.scheme;
      parameters.contact = row.contact;
      parameters.modes = row.modes;
      parameters.penalty_stiffness = row.penalty;
      parameters.steps_per_revolution = steps;
      std::printf("%d\t%s\t%d\t%s\n", number, row.name, steps, verdict(run(wheel, parameters), reference));
      std::fflush(stdout);
    }
    ++number;
  }
}

}  // namespace tiprub::bench
