// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/benchmark/benchmarks.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double families = 6, beyond = 0.02;        // of the damping: so many take the light one
constexpr double slowest = 0.6, fastest = 0.99;      // of the model's highest speed
constexpr double dampings[] = {0.002, 0.005, 0.02};  // of critical
constexpr Patience patience{20, 200, 6, 1e-4};       // as a case has it by default

struct Run {
  SpeedResponse response;
  double seconds;
};

Run timed(const BenchWheel& wheel, double damping, double speed, SteadyStateMethod method) {
  SimulateParameters parameters = bench_parameters(wheel, patience);
  std::vector<double> by_family(static_cast<std::size_t>(families), damping);
  by_family.push_back(beyond);
  parameters.damping.ratios = {.by_family = by_family};
  parameters.resolved_frequency = 0;
  parameters.damping_ratio_beyond = beyond;
  fit_to_model(parameters, wheel.model);
  parameters.symmetry_check_revolutions = 24;
  parameters.steady_state = method;
  const double start = cpu_seconds();
  SpeedResponse response = run_speed(wheel, parameters, speed);
  return {std::move(response), cpu_seconds() - start};
}

void print_damping(const BenchWheel& wheel, double damping, int speeds) {
  double marched = 0, sought = 0, apart = 0;
  int found = 0;
  for (int i = 0; i < speeds; ++i) {
    const double share = slowest + (fastest - slowest) * (i + 0.5) / speeds, speed = share * wheel.model.speed_max;
    const Run march = timed(wheel, damping, speed, SteadyStateMethod::march),
              orbit = timed(wheel, damping, speed, SteadyStateMethod::orbit);
    const OrbitReport& report = orbit.response.audit.orbit;
    const bool is_found = report.outcome == OrbitReport::Outcome::found;
    const double difference = std::abs(orbit.response.amplitude / march.response.amplitude - 1);
    std::printf("%.3f\t%.1f\t%.3f\t%.3f\t%.2f\t%s\t%.4f\t%.1e\n", damping, speed, march.seconds, orbit.seconds,
                march.seconds / orbit.seconds, is_found ? "orbit" : name_of(march.response.motion), report.multiplier,
                difference);
    marched += march.seconds;
    sought += orbit.seconds;
    found += is_found;
    apart = std::max(apart, difference);
  }
  std::printf("# damping %.3f: %d of %d are orbits; march %.1f s, orbit %.1f s, ratio %.2f; amplitudes within %.1e\n",
              damping, found, speeds, marched, sought, marched / sought, apart);
}

}  // namespace

void print_orbit_cost(const std::string& model, int lobes, int speeds) {
  const BenchWheel wheel = model.empty() ? made_wheel(lobes) : given_wheel(model, lobes);
  std::printf("# %s against %d lobes: the settled answer at a speed, symmetry checked, by marching and as an orbit\n",
              wheel.name.c_str(), lobes);
  std::printf(
      "# damping\trad/s\tmarch [s]\torbit [s]\tratio\tmotion\tmultiplier a revolution\tamplitudes differ by\n");
  for (const double damping : dampings) print_damping(wheel, damping, speeds);
}

}  // namespace tiprub::simulate::testing
