// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "simulate/march/time_march.h"
#include "simulate/scene/scene.h"
#include "tests/benchmark/benchmarks.h"
#include "tests/benchmark/step_bound.h"
#include "tests/benchmark/whole_rotor.h"
#include "tests/simulate/march/dense_ring.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::testing {

namespace {

constexpr int rounds = 7;  // of which the median counts: the machine has other users

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A march whose steps are timed in turn with those of the others, so that all see the same state of the machine.
struct Contender {
  std::string name;
  std::function<std::size_t()> step;                     ///< returns how many nodes are closed
  int steps = 0;                                         ///< a revolution
  int timed_steps = 0;                                   ///< a round
  std::function<StepCount(double closed)> counted = {};  ///< empty if its bound is not known
  std::vector<double> seconds = {};                      ///< of each round
  std::size_t closed = 0;                                ///< nodes, over all timed steps

  double microseconds() const { return 1e6 * median(seconds) / timed_steps; }
  double mean_closed() const { return static_cast<double>(closed) / timed_steps / rounds; }
  double bound(const MachineRates& rates) const { return counted ? counted(mean_closed()).least(rates) : 0; }
};

void time_round(Contender& at) {
  const double start = cpu_seconds();
  for (int i = 0; i < at.timed_steps; ++i) at.closed += at.step();
  at.seconds.push_back(cpu_seconds() - start);
}

/// Times all of them; the median rates of the processor in the same rounds.
MachineRates time_in_turn(std::vector<Contender>& contenders) {
  std::vector<double> flops, bytes;
  for (int r = 0; r < rounds; ++r) {
    const MachineRates rates = machine_rates();
    flops.push_back(rates.flops);
    bytes.push_back(rates.bytes);
    for (Contender& at : contenders) time_round(at);
  }
  return {median(flops), median(bytes)};
}

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

/// A march that has settled as far as cost goes. A round is one revolution.
Contender settled(const char* name, const std::shared_ptr<TimeMarch>& march, double ramp_revolutions) {
  constexpr int more_revolutions = 8;
  Contender at{name,
               [march] {
                 march->step();
                 return march->contact().closed().size();
               },
               march->steps_per_revolution(), march->steps_per_revolution()};
  const int settling = static_cast<int>(ramp_revolutions + more_revolutions) * at.steps;
  for (int i = 0; i < settling; ++i) march->step();
  return at;
}

/// What a step has besides normal contact with a linear gap.
struct Physics {
  double friction = 0;  ///< [1] mu
  GapOrder gap = GapOrder::linear;
};

Contender modal(const char* name, const BenchWheel& wheel, Scheme scheme, int symmetry, const Physics& physics = {}) {
  const RotorAtSpeed rotor = rotor_at_speed(wheel.model, wheel.speed, nodal_diameters(wheel, symmetry),
                                            {wheel.damping}, {.sliding_below = resolved_frequency(wheel.model)});
  const int steps = scheme == Scheme::central_differences ? central_steps(wheel, rotor) : default_steps(wheel, rotor);
  MarchSetup setup{scheme, ContactRule::complementarity, steps, symmetry};
  if (physics.friction > 0) setup.friction = Eigen::VectorXd::Constant(1, physics.friction);
  setup.gap = physics.gap;
  const auto march =
      std::make_shared<TimeMarch>(march_of(rotor, wheel.casing, wheel.model.contact,
                                           wheel.casing.running_clearance(wheel.model.contact, wheel.speed), setup));
  Contender at = settled(name, march, wheel.casing.ramp_revolutions);
  if (physics.friction == 0 && physics.gap == GapOrder::linear)
    at.counted = [march](double closed) { return count_step(march->rotor(), march->sectors(), closed); };
  return at;
}

/// The whole wheel in its real modes, with the same kernels.
Contender plain_modal(const char* name, const BenchWheel& wheel, ContactRule rule) {
  const RotorAtSpeed rotor = rotor_at_speed(wheel.model, wheel.speed, nodal_diameters(wheel, 1), {wheel.damping});
  const WholeRotor whole = whole_rotor(rotor, wheel.model.contact);
  const Eigen::VectorXd clearance = wheel.casing.running_clearance(wheel.model.contact, wheel.speed);
  const auto march = std::make_shared<TimeMarch>(
      march_of(whole.rotor, wheel.casing, whole.contact, clearance.replicate(rotor.sector_count, 1),
               {Scheme::central_differences, rule, central_steps(wheel, rotor), 1}));
  return settled(name, march, wheel.casing.ramp_revolutions);
}

/// The dense form, over as many steps as show its cost; the contact in it is that of the casing at rest in a crest.
Contender dense_march(const char* name, const BenchWheel& wheel, int steps) {
  constexpr int counted = 400;
  Casing casing = wheel.casing;
  casing.ramp_revolutions = 1e-3;  // the casing is there at once
  const auto kept = std::make_shared<std::pair<ReducedModel, Casing>>(wheel.model, casing);
  const auto ring =
      std::make_shared<DenseRing>(kept->first, kept->second, wheel.speed, wheel.damping, steps, ContactRule::paper);
  Contender at{name,
               [kept, ring] {
                 ring->step();
                 return static_cast<std::size_t>((ring->multipliers().array() != 0).count());
               },
               steps, counted};
  for (int i = 0; i < counted; ++i) at.step();
  return at;
}

std::vector<Contender> all_marches(const BenchWheel& three, const BenchWheel& two) {
  const auto in_the_air = [](BenchWheel wheel) {
    wheel.casing.clearance = {{0.0, 1.0}, {1.0, 1.0}};
    return wheel;
  };
  const int in_three = std::gcd(three.model.sector_count, 3), in_two = std::gcd(two.model.sector_count, 2);
  constexpr double friction = 0.1;
  const auto usual = [](const char* name, const BenchWheel& wheel, int symmetry, const Physics& physics = {}) {
    return modal(name, wheel, Scheme::trigonometric, symmetry, physics);
  };
  Contender central = modal("modal, central differences, three lobes", three, Scheme::central_differences, 1);
  std::vector<Contender> all{dense_march("dense eqs. 13-15", three, central.steps),
                             plain_modal("plain modal, eq. 14 as printed", three, ContactRule::paper),
                             plain_modal("plain modal, complementarity", three, ContactRule::complementarity)};
  all.push_back(std::move(central));
  all.push_back(usual("three lobes", three, in_three));
  all.push_back(usual("three lobes, in the air", in_the_air(three), in_three));
  all.push_back(usual("two lobes", two, in_two));
  all.push_back(usual("two lobes, in the air", in_the_air(two), in_two));
  all.push_back(usual("two lobes, friction", two, in_two, {friction}));
  if (!two.model.contact.second_order) return all;
  all.push_back(usual("two lobes, second order", two, in_two, {0, GapOrder::second_order}));
  all.push_back(usual("two lobes, both", two, in_two, {friction, GapOrder::second_order}));
  return all;
}

}  // namespace

void print_step_costs(const std::string& model) {
  const auto wheel = [&](int lobes) { return model.empty() ? made_wheel(lobes) : given_wheel(model, lobes); };
  const BenchWheel three = wheel(3);
  std::vector<Contender> all = all_marches(three, wheel(2));
  const MachineRates rates = time_in_turn(all);
  std::printf("# %s: %d dofs at %.0f rad/s; this processor now: %.0f Gflop/s, %.0f GB/s; medians of %d rounds\n",
              three.name.c_str(),
              static_cast<int>(three.model.sector_count * three.model.nodal_diameters[0].M.rows()), three.speed,
              1e-9 * rates.flops, 1e-9 * rates.bytes, rounds);
  std::printf(
      "march\tstep_us\tbound_us\tover_bound\tclosed\tsteps\tdense_over_it\tplain_modal_over_it\t"
      "dense_over_it_a_revolution\n");
  const Contender &dense = all[0], &plain = all[2];
  for (const Contender& at : all) {
    const double step = at.microseconds(), bound = at.bound(rates), faster = dense.microseconds() / step;
    std::printf("%s\t%.3f\t%.3f\t%.2f\t%.1f\t%d\t%.1f\t%.2f\t%.1f\n", at.name.c_str(), step, bound,
                bound > 0 ? step / bound : 0, at.mean_closed(), at.steps, faster, plain.microseconds() / step,
                faster * dense.steps / at.steps);
  }
}

}  // namespace tiprub::simulate::testing
