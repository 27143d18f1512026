// SPDX-License-Identifier: GPL-3.0-or-later
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <vector>

#include "simulate/march/time_march.h"
#include "simulate/scene/scene.h"
#include "tests/benchmark/benchmarks.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::testing {

namespace {

constexpr WheelPlan usual{10, 10, 60};
constexpr int usual_lobes = 3;
constexpr double usual_tip_share = 0.04;

/// What one size costs.
struct Cost {
  double size = 0;    ///< what is varied
  double time = 0;    ///< [s] of the processor
  double memory = 0;  ///< [bytes] on the heap; 0 if not measured
};

double heap_bytes() {
  const struct mallinfo2 now = mallinfo2();
  return static_cast<double>(now.uordblks) + static_cast<double>(now.hblkhd);
}

SimulateParameters parameters_for(const BenchWheel& wheel) {
  return bench_parameters(wheel, {20, 200, 6, 1e-4});
}

/// A revolution of the default, in contact: the least time of some, and the memory of the rotor and its march.
Cost revolution(double size, const WheelPlan& plan, int lobes) {
  constexpr int settling = 6, repeats = 7;
  const BenchWheel wheel = made_wheel(lobes, usual_tip_share, plan);
  const double before = heap_bytes();
  const SimulateParameters parameters = parameters_for(wheel);
  const SceneScope scope = find_scope(plan.sectors, lobes, parameters);
  const Scene scene{wheel.model, wheel.casing, parameters, scope};
  const SharedRotor rotor = rotor_of(scene, wheel.speed);
  const int steps = steps_per_revolution(scope, parameters, rotor->first_frequency, wheel.speed);
  TimeMarch march(marched_scene(scene, rotor, steps));
  Cost cost{size, HUGE_VAL, heap_bytes() - before};
  const auto turn = [&] {
    const double start = cpu_seconds();
    for (int i = 0; i < steps; ++i) march.step();
    return cpu_seconds() - start;
  };
  for (int i = 0; i < settling; ++i) turn();
  for (int i = 0; i < repeats; ++i) cost.time = std::min(cost.time, turn());
  return cost;
}

/// Some speeds by marching from rest to the settled motion.
Cost settled_speeds(double damping) {
  constexpr int speeds = 6;
  const BenchWheel wheel = made_wheel(2);
  SimulateParameters parameters = parameters_for(wheel);
  parameters.damping = {damping};
  const double start = cpu_seconds();
  for (int i = 0; i < speeds; ++i) run_speed(wheel, parameters, wheel.speed * (0.8 + 0.4 * i / speeds));
  return {damping, (cpu_seconds() - start) / speeds};
}

/// p of size^p, by least squares of the logarithms.
double exponent(const std::vector<Cost>& costs, double Cost::*what) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const Cost& at : costs) {
    const double a = std::log(at.size), b = std::log(at.*what);
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  const auto n = static_cast<double>(costs.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

void print(const char* varied, const char* unit, const std::vector<Cost>& costs) {
  std::printf("# %s: time grows as its power %.2f", varied, exponent(costs, &Cost::time));
  const bool has_memory = costs[0].memory > 0;
  if (has_memory) std::printf(", memory as its power %.2f", exponent(costs, &Cost::memory));
  std::printf("\n");
  for (const Cost& at : costs)
    std::printf("%s\t%s\t%g\t%.4g\t%.4g\n", varied, unit, at.size, 1e3 * at.time, at.memory / 1048576);
  std::printf("\n\n");
  std::fflush(stdout);
}

}  // namespace

void print_scaling() {
  std::printf("# made-up wheels; the default step\n# varied\tof what\tvalue\ttime [ms]\tmemory [MiB]\n");
  std::vector<Cost> costs;
  const auto over = [&](std::initializer_list<int> sizes, const auto& cost_of) {
    costs.clear();
    for (const int size : sizes) costs.push_back(cost_of(size));
  };
  // One lobe moves all nodal diameters whatever the number of blades.
  over({6, 10, 15, 22, 30, 40}, [](int n) { return revolution(n, {n, usual.contact_nodes, usual.generalized}, 1); });
  print("blades", "a revolution", costs);
  over({1, 2, 3, 5, 10}, [](int lobes) { return revolution(lobes, usual, lobes); });
  print("lobes", "a revolution", costs);
  over({5, 7, 10, 12, 20, 28}, [](int nodes) {
    return revolution(nodes, {usual.sectors, nodes, usual.generalized}, usual_lobes);
  });
  print("contact nodes", "a revolution", costs);
  over({30, 60, 120, 240}, [](int more) {
    return revolution(3 * usual.contact_nodes + more, {usual.sectors, usual.contact_nodes, more}, usual_lobes);
  });
  print("dofs of a sector", "a revolution", costs);
  over({1, 2, 5, 10, 20, 50}, [](int thousandths) { return settled_speeds(1e-3 * thousandths); });
  print("damping", "a settled speed", costs);
}

}  // namespace tiprub::simulate::testing
