// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>

#include "simulate/orbits/speed_audit.h"
#include "tests/benchmark/benchmarks.h"

namespace tiprub::testing {

namespace {

constexpr double inaccurate = 5e-2;  // relative error from which on a stable run is of no use
constexpr int reference_steps = 9600;
constexpr Patience patience = {20, 60, 6, 1e-4};

const char* outcome(const SpeedResponse& at, const SpeedResponse& reference, int lobes) {
  if (at.failure.find("grew beyond") != std::string::npos) return "blown_up";
  if (!at.failure.empty()) return "refused";
  return difference(at, reference, lobes).value > inaccurate ? "inaccurate" : "stable";
}

struct Row {
  const char* name;
  Scheme scheme;
  ContactRule contact = ContactRule::complementarity;
  int modes = 0;
  double penalty = 0;
};

constexpr Row rows[] = {
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

SpeedResponse run_row(const BenchWheel& wheel, const Row& row, int steps) {
  SimulateParameters parameters = bench_parameters(wheel, patience);
  parameters.scheme = row.scheme;
  parameters.contact = row.contact;
  parameters.modes = row.modes;
  parameters.penalty_stiffness = row.penalty;
  parameters.steps_per_revolution = steps;
  return run_speed(wheel, parameters, wheel.speed);
}

}  // namespace

void print_stability(const std::string& model) {
  const BenchWheel wheel = model.empty() ? made_wheel(2) : given_wheel(model, 2);
  SimulateParameters fine = bench_parameters(wheel, patience);
  fine.steps_per_revolution = reference_steps;
  const SpeedResponse reference = run_speed(wheel, fine, wheel.speed);
  std::printf("# %s at %.1f rad/s\n# row\tname\tsteps a revolution\tverdict\n", wheel.name.c_str(), wheel.speed);
  int number = 0;
  for (const Row& row : rows) {
    for (int steps : {240, 480, 960, 1920, 3840, 7680, 15360}) {
      std::printf("%d\t%s\t%d\t%s\n", number, row.name, steps,
                  outcome(run_row(wheel, row, steps), reference, wheel.casing.lobes));
      std::fflush(stdout);
    }
    ++number;
  }
}

}  // namespace tiprub::testing
