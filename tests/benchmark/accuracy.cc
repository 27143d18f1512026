// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <numbers>

#include "simulate/scene/scene.h"
#include "tests/benchmark/benchmarks.h"
#include "tests/simulate/compared_responses.h"

namespace tiprub::simulate::testing {

namespace {

constexpr int reference_steps = 16 * 2400;

SimulateParameters parameters_for(const BenchWheel& wheel, Scheme scheme, int steps) {
  SimulateParameters parameters = bench_parameters(wheel, {30, 120, 6, 1e-5});
  parameters.scheme = scheme;
  parameters.steps_per_revolution = steps;
  return parameters;
}

struct Run {
  SpeedResponse response;
  double milliseconds = 0;  ///< a revolution, all of it: set-up, march, recording
};

Run run(const BenchWheel& wheel, const SimulateParameters& parameters) {
  const double start = cpu_seconds();
  Run result{run_speed(wheel, parameters, wheel.speed), 0};
  result.milliseconds = (cpu_seconds() - start) * 1e3 / std::max(result.response.revolutions, 1);
  return result;
}

/// Real multiplications a revolution: the free flight and the map to the nodes of each mode with mass, in every step;
/// back, in contact steps, and one triangular solve of the closed nodes there (about a third of all, squared).
double operations(const BenchWheel& wheel, const SimulateParameters& parameters, const SpeedResponse& at) {
  const SceneScope scope = find_scope(wheel.model.sector_count, wheel.casing.lobes, parameters);
  const double nodes = wheel.model.contact.size();
  const double all = static_cast<double>(wheel.model.nodal_diameters[0].M.rows());
  const double moving = parameters.modes > 0 ? parameters.modes : all;
  const double in_contact = static_cast<double>(at.contact_steps) / at.recorded_revolutions;
  double sum = 0;
  for (int n : scope.nodal_diameters) {
    const double parts = is_standing(n, wheel.model.sector_count) ? 1 : 4;
    sum +=
        at.steps_per_revolution * moving * (parts * nodes + 2 * std::sqrt(parts)) + in_contact * all * parts * nodes;
  }
  const double closed = scope.independent_sectors * nodes / 3;
  return sum + in_contact * closed * closed;
}

void print(const char* group, const char* name, const BenchWheel& wheel, const SimulateParameters& parameters,
           const SpeedResponse& reference) {
  const Run at = run(wheel, parameters);
  if (!at.response.failure.empty()) {
    std::printf("%s\t%s\t%d\t%d\tnan\tnan\tnan\tfailed\n", group, name, parameters.steps_per_revolution,
                parameters.modes);
    return;
  }
  const MotionDifference error = difference(at.response, reference, wheel.casing.lobes);
  std::printf("%s\t%s\t%d\t%d\t%.3e\t%.4f\t%.4e\t%s\n", group, name, at.response.steps_per_revolution,
              parameters.modes, error.value, at.milliseconds, operations(wheel, parameters, at.response),
              error.measure == MotionMeasure::motion ? "motion" : "spectrum");
  std::fflush(stdout);
}

}  // namespace

void print_accuracy(const std::string& model) {
  const BenchWheel wheel = model.empty() ? made_wheel(2) : given_wheel(model, 2);
  std::printf("# %s at %.1f rad/s; error against %d steps of the default\n", wheel.name.c_str(), wheel.speed,
              reference_steps);
  std::printf(
      "# group\tscheme\tsteps a revolution\tmodes\terror\tms a revolution\toperations a revolution\tmeasure\n");
  const SpeedResponse reference = run(wheel, parameters_for(wheel, Scheme::trigonometric, reference_steps)).response;
  print("default", "trigonometric", wheel, parameters_for(wheel, Scheme::trigonometric, 0), reference);
  for (int steps : {240, 480, 960, 1440, 2400, 4800, 9600, 19200}) {
    const auto with = [&](Scheme scheme) { return parameters_for(wheel, scheme, steps); };
    print("scheme", "trigonometric", wheel, with(Scheme::trigonometric), reference);
    print("scheme", "moreau_jean", wheel, with(Scheme::moreau_jean), reference);
    SimulateParameters residual = with(Scheme::residual_flexibility);
    residual.modes = 30;
    print("scheme", "residual_flexibility", wheel, residual, reference);
    print("scheme", "central_differences", wheel, with(Scheme::central_differences), reference);
    SimulateParameters paper = with(Scheme::central_differences);
    paper.contact = ContactRule::paper;
    print("scheme", "paper", wheel, paper, reference);
    SimulateParameters full = with(Scheme::trigonometric);
    full.nodal_diameters = DiameterChoice::all;
    if (steps <= 4800) print("full", "all_nodal_diameters", wheel, full, reference);
  }
  for (int steps : {9600, 19200, 38400, 57600})
    for (double stiffness : {1.0, 10.0}) {  // of the stiffest tip; stiffer ones need shorter steps still
      SimulateParameters penalty = parameters_for(wheel, Scheme::penalty, steps);
      penalty.penalty_stiffness = stiffness;
      print("scheme", stiffness > 1 ? "penalty_10" : "penalty_1", wheel, penalty, reference);
    }
  for (int modes : {5, 10, 15, 20, 30, 45, 60, 80})
    for (const Scheme scheme : {Scheme::residual_flexibility, Scheme::trigonometric}) {
      SimulateParameters few = parameters_for(wheel, scheme, 1440);
      few.modes = modes;
      print("modes", scheme == Scheme::trigonometric ? "dropped" : "quasi_static", wheel, few, reference);
    }
}

}  // namespace tiprub::simulate::testing
