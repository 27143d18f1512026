// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "simulate/march/time_march.h"
#include "simulate/scene/scene.h"
#include "tests/benchmark/benchmarks.h"
#include "tests/benchmark/step_bound.h"
#include "tests/benchmark/whole_rotor.h"
#include "tests/simulate/march/dense_ring.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::testing {

namespace {

constexpr int repetitions = 5;  // of which the best counts: the machine has other users

struct Cost {
  double microseconds = 0;  ///< a step
  double closed = 0;        ///< nodes, on average
  int steps = 0;            ///< a revolution
  double least = 0;         ///< [us] its bound, if it has one
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

/// The best revolution, once the casing is there; of a march that has settled as far as cost goes.
Cost timed(TimeMarch& march, double ramp_revolutions) {
  constexpr int more_revolutions = 8;
  Cost cost{HUGE_VAL, 0, march.steps_per_revolution()};
  const int settling = static_cast<int>(ramp_revolutions + more_revolutions) * cost.steps;
  for (int i = 0; i < settling; ++i) march.step();
  for (int r = 0; r < repetitions; ++r) {
    std::size_t closed = 0;
    const double start = cpu_seconds();
    for (int i = 0; i < cost.steps; ++i) {
      march.step();
      closed += march.contact().closed().size();
    }
    cost.microseconds = std::min(cost.microseconds, (cpu_seconds() - start) / cost.steps * 1e6);
    cost.closed = static_cast<double>(closed) / cost.steps;
  }
  return cost;
}

Cost march_cost(const BenchWheel& wheel, Scheme scheme, int symmetry, const MachineRates& rates, double friction = 0,
                GapOrder gap = GapOrder::linear) {
  const RotorAtSpeed rotor = rotor_at_speed(wheel.model, wheel.speed, nodal_diameters(wheel, symmetry),
                                            {wheel.damping}, {.sliding_below = resolved_frequency(wheel.model)});
  const int steps = scheme == Scheme::central_differences ? central_steps(wheel, rotor) : default_steps(wheel, rotor);
  MarchSetup setup{scheme, ContactRule::complementarity, steps, symmetry};
  if (friction > 0) setup.friction = Eigen::VectorXd::Constant(1, friction);
  setup.gap = gap;
  TimeMarch march = march_of(rotor, wheel.casing, wheel.model.contact,
                             wheel.casing.running_clearance(wheel.model.contact, wheel.speed), setup);
  Cost cost = timed(march, wheel.casing.ramp_revolutions);
  if (friction == 0 && gap == GapOrder::linear)
    cost.least = count_step(rotor, march.sectors(), cost.closed).least(rates);
  return cost;
}

/// The whole wheel in its real modes, with the same kernels.
Cost whole_cost(const BenchWheel& wheel, ContactRule rule) {
  const RotorAtSpeed rotor = rotor_at_speed(wheel.model, wheel.speed, nodal_diameters(wheel, 1), {wheel.damping});
  const WholeRotor whole = whole_rotor(rotor, wheel.model.contact);
  const Eigen::VectorXd clearance = wheel.casing.running_clearance(wheel.model.contact, wheel.speed);
  TimeMarch march = march_of(whole.rotor, wheel.casing, whole.contact, clearance.replicate(rotor.sector_count, 1),
                             {Scheme::central_differences, rule, central_steps(wheel, rotor), 1});
  return timed(march, wheel.casing.ramp_revolutions);
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
    Eigen::Index closed = 0;
    const double start = cpu_seconds();
    for (int i = 0; i < counted; ++i) {
      dense.step();
      closed += (dense.multipliers().array() != 0).count();
    }
    cost.microseconds = std::min(cost.microseconds, (cpu_seconds() - start) / counted * 1e6);
    cost.closed = static_cast<double>(closed) / counted;
  }
  return cost;
}

/// What a step is compared with.
struct References {
  Cost dense, whole_paper, whole;
};

void print(const char* name, const Cost& cost, const References& over) {
  std::printf("%-46s %8.2f us", name, cost.microseconds);
  if (cost.least > 0)
    std::printf(" %8.2f us %5.1f", cost.least, cost.microseconds / cost.least);
  else
    std::printf(" %8s    %5s", "", "");
  std::printf(" %6.1f closed %6d steps %8.1f %8.1f %8.1f\n", cost.closed, cost.steps,
              over.dense.microseconds / cost.microseconds, over.whole_paper.microseconds / cost.microseconds,
              over.whole.microseconds / cost.microseconds);
  std::fflush(stdout);
}

}  // namespace

void print_step_costs(const std::string& model) {
  const auto wheel = [&](int lobes) { return model.empty() ? made_wheel(lobes) : given_wheel(model, lobes); };
  const BenchWheel three = wheel(3), two = wheel(2);
  const MachineRates rates = machine_rates();
  std::printf("%s: %d dofs at %.0f rad/s; this processor now: %.0f Gflop/s, %.0f GB/s\n", three.name.c_str(),
              static_cast<int>(three.model.sector_count * three.model.nodal_diameters[0].M.rows()), three.speed,
              1e-9 * rates.flops, 1e-9 * rates.bytes);
  std::printf("%-46s %11s %11s %5s %13s %12s   the three references over this, a step\n", "", "a step", "bound",
              "ratio", "", "a revolution");
  const Cost central = march_cost(three, Scheme::central_differences, 1, rates);
  const References over{dense_cost(three, central.steps), whole_cost(three, ContactRule::paper),
                        whole_cost(three, ContactRule::complementarity)};
  print("dense eq. 13, eq. 14, eq. 15", over.dense, over);
  print("whole wheel in its modes, eq. 14 as printed", over.whole_paper, over);
  print("whole wheel in its modes, complementarity", over.whole, over);
  print("modal central differences, three lobes", central, over);
  print("trigonometric, three lobes (no symmetry)", march_cost(three, Scheme::trigonometric, 1, rates), over);
  BenchWheel free = three;
  free.casing.clearance = {{0.0, 1.0}, {1.0, 1.0}};
  print("the same, in the air", march_cost(free, Scheme::trigonometric, 1, rates), over);
  print("trigonometric, two lobes (symmetry)", march_cost(two, Scheme::trigonometric, 2, rates), over);
  constexpr double friction = 0.1;
  print("the same, with friction", march_cost(two, Scheme::trigonometric, 2, rates, friction), over);
  if (!two.model.contact.second_order) return;
  const auto curved = [&](double coefficient) {
    return march_cost(two, Scheme::trigonometric, 2, rates, coefficient, GapOrder::second_order);
  };
  print("the same, with a gap of second order", curved(0), over);
  print("the same, with both", curved(friction), over);
}

}  // namespace tiprub::simulate::testing
