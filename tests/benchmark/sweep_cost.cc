// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "tests/benchmark/benchmarks.h"

namespace tiprub::simulate::testing {

namespace {

constexpr int whole_sweep = 400, revolutions = 60, recorded = 6;
constexpr double slowest = 0.6, fastest = 1.4;  // of the wheel's speed

}  // namespace

void print_sweep_cost(const std::string& model, int speeds) {
  const BenchWheel wheel = model.empty() ? made_wheel(3) : given_wheel(model, 3);
  SimulateParameters parameters = bench_parameters(wheel, {revolutions, revolutions, recorded, 1e-4});
  parameters.casing_areas = 200;
  std::printf("# %s, three lobes, %d revolutions a speed\n# rad/s\tsteps a revolution\tcontact\tms a revolution\n",
              wheel.name.c_str(), revolutions);
  double sum = 0;
  for (int i = 0; i < speeds; ++i) {
    const double speed = wheel.speed * (slowest + (fastest - slowest) * (i + 0.5) / speeds);
    const double start = cpu_seconds();
    const SpeedResponse at = run_speed(wheel, parameters, speed);
    const double spent = cpu_seconds() - start;
    sum += spent;
    if (!at.failure.empty()) std::printf("# %s\n", at.failure.c_str());
    std::printf("%.1f\t%d\t%.2f\t%.2f\n", speed, at.steps_per_revolution,
                static_cast<double>(at.contact_steps) / (static_cast<double>(at.steps_per_revolution) * recorded),
                1e3 * spent / at.revolutions);
    std::fflush(stdout);
  }
  std::printf("# %d speeds took %.1f core-seconds; %d of them: %.0f\n", speeds, sum, whole_sweep,
              sum / speeds * whole_sweep);
}

}  // namespace tiprub::simulate::testing
