// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "simulate/march/time_march.h"
#include "simulate/scene/scene_scope.h"
#include "tests/benchmark/benchmarks.h"
#include "tests/simulate/march/dense_ring.h"

namespace tiprub::testing {

namespace {

constexpr int repetitions = 5;  // of which the best counts: the machine has other users

struct Cost {
  double microseconds = 0;  ///< a step
  double contact = 0;       ///< [1] share of the steps
  int steps = 0;            ///< a revolution

  double per_revolution() const { return microseconds * steps * 1e-3; }  ///< [ms]
};

/// Steps a revolution of the default, and those that central differences need.
int default_steps(const BenchWheel& wheel, const RotorAtSpeed& rotor) {
  SimulateParameters parameters;
  parameters.samples_per_revolution = 240;
  const SceneScope scope = find_scope(wheel.model.sector_count, wheel.casing.lobes, parameters);
  return steps_per_revolution(scope, parameters, rotor.first_frequency, wheel.speed);
}

int central_steps(const BenchWheel& wheel, const RotorAtSpeed& rotor) {
  constexpr double margin = 1.02;
  constexpr int unit = 240;
  const double limit = std::numbers::pi / wheel.speed * rotor.omega_max;
  return unit * static_cast<int>(std::ceil(margin * limit / unit));
}

Cost march_cost(const BenchWheel& wheel, Scheme scheme, int symmetry, bool fine) {
  const RotorAtSpeed rotor =
      rotor_at_speed(wheel.model, wheel.speed, nodal_diameters(wheel, symmetry), {wheel.damping});
  Cost cost;
  cost.steps = fine ? central_steps(wheel, rotor) : default_steps(wheel, rotor);
  TimeMarch march(rotor, wheel.casing, wheel.model.contact,
                  wheel.casing.running_clearance(wheel.model.contact, wheel.speed),
                  {scheme, ContactRule::complementarity, cost.steps, symmetry});
  const int settling = static_cast<int>(wheel.casing.ramp_revolutions + 8) * cost.steps;
  for (int i = 0; i < settling; ++i) march.step();
  cost.microseconds = HUGE_VAL;
  for (int r = 0; r < repetitions; ++r) {
    int contacts = 0;
    const double start = cpu_seconds();
    for (int i = 0; i < cost.steps; ++i) {
      march.step();
      contacts += march.contact().closed().empty() ? 0 : 1;
    }
    cost.microseconds = std::min(cost.microseconds, (cpu_seconds() - start) / cost.steps * 1e6);
    cost.contact = static_cast<double>(contacts) / cost.steps;
  }
  return cost;
}

/// The dense form, over as many steps as show its cost; the contact in it is that of the casing at rest in a crest.
Cost dense_cost(const BenchWheel& wheel, int steps) {
  constexpr int counted = 400;
  Casing casing = wheel.casing;
  casing.ramp_revolutions = 1e-3;  // the casing is there at once
  testing::DenseRing dense(wheel.model, casing, wheel.speed, wheel.damping, steps, ContactRule::paper);
  for (int i = 0; i < counted; ++i) dense.step();
  Cost cost{HUGE_VAL, 0, steps};
  for (int r = 0; r < repetitions; ++r) {
    int contacts = 0;
    const double start = cpu_seconds();
    for (int i = 0; i < counted; ++i) {
      dense.step();
      contacts += dense.multipliers().cwiseAbs().maxCoeff() > 0 ? 1 : 0;
    }
    cost.microseconds = std::min(cost.microseconds, (cpu_seconds() - start) / counted * 1e6);
    cost.contact = static_cast<double>(contacts) / counted;
  }
  return cost;
}

void print(const char* name, const Cost& cost, const Cost& dense) {
  std::printf("%-44s %8.2f us a step  %3.0f %% in contact  %6d steps  %9.2f ms a revolution  %6.1f  %6.1f\n", name,
              cost.microseconds, 100 * cost.contact, cost.steps, cost.per_revolution(),
              dense.microseconds / cost.microseconds, dense.per_revolution() / cost.per_revolution());
}

}  // namespace

void print_step_costs(const std::string& model) {
  const auto wheel = [&](int lobes) { return model.empty() ? made_wheel(lobes) : given_wheel(model, lobes); };
  const BenchWheel three = wheel(3), two = wheel(2);
  std::printf("%s: %d dofs at %.0f rad/s; the last columns: the dense form over this, a step and a revolution\n",
              three.name.c_str(),
              static_cast<int>(three.model.sector_count * three.model.nodal_diameters[0].M.rows()), three.speed);
  const Cost central = march_cost(three, Scheme::central_differences, 1, true);
  const Cost dense = dense_cost(three, central.steps);
  print("dense eq. 13, eq. 14, eq. 15 (reference)", dense, dense);
  print("modal central differences, three lobes", central, dense);
  print("trigonometric, three lobes (no symmetry)", march_cost(three, Scheme::trigonometric, 1, false), dense);
  print("trigonometric, two lobes (symmetry)", march_cost(two, Scheme::trigonometric, 2, false), dense);
}

}  // namespace tiprub::testing
