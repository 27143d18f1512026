// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/step_bound.h"

#include <algorithm>
#include <vector>

#include "cases/program/vector_lanes.h"
#include "simulate/march/cache_lines.h"
#include "tests/benchmark/bench_wheel.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double size_of = sizeof(double);
constexpr int trials = 40;
constexpr std::size_t eight = 8;

/// Twenty-four chains of additions to products, of eight doubles each.
struct MultiplyAndAdd {
  static constexpr int chains = 12;  // at once, in a register each
  template <class Set>
  TIPRUB_INLINE static double run(int count) {
    typename Set::Register sums[chains];
    for (int k = 0; k < chains; ++k) sums[k] = typename Set::Register{} + k;  // equal chains would be one
    const typename Set::Register factor = typename Set::Register{} + 0.999, more = typename Set::Register{} + 1e-3;
    const int rounds = 2 * static_cast<int>(Set::registers) * count;
    for (int i = 0; i < rounds; ++i)
#pragma GCC unroll 12
      for (int k = 0; k < chains; ++k) sums[k] = sums[k] * factor + more;
    typename Set::Register all = {};
    for (int k = 0; k < chains; ++k) all += sums[k];
    return all[0];
  }
};

struct AddAll {
  template <class Set>
  TIPRUB_INLINE static double run(const double* values, std::size_t count) {
    constexpr std::size_t lanes = eight / Set::registers;
    typename Set::Register sums[eight] = {};
    for (std::size_t i = 0; i < count; i += eight * lanes)
      for (std::size_t k = 0; k < eight; ++k) sums[k] += tiprub::lanes<Set>(values + i + lanes * k);
    typename Set::Register all = {};
    for (std::size_t k = 0; k < eight; ++k) all += sums[k];
    return all[0];
  }
};

/// [s] the best of some trials.
template <class Run>
double least_seconds(const Run& run) {
  double least = 1e300;
  volatile double kept = 0;
  for (int i = 0; i < trials; ++i) {
    const double start = cpu_seconds();
    kept = run();
    least = std::min(least, cpu_seconds() - start);
  }
  static_cast<void>(kept);
  return least;
}

StepPart waves_part(const RotorAtSpeed& rotor, double sectors, double closed) {
  StepPart part;
  for (const WaveModes& wave : rotor.waves) {
    const double parts = wave.kind == WaveKind::travelling ? 2 : 1;
    const auto nodes = static_cast<double>(wave.normal_rows.rows()), modes = static_cast<double>(wave.moving);
    part.bytes += size_of * modes * (parts * nodes + 3 + 3 * parts);
    const double map = 2 * parts * parts * nodes * modes;  // one way between modes and nodes
    part.flops += (closed > 0 ? 2 * map + 2 * parts * modes : map) + 3 * parts * modes;
    part.flops += 2 * parts * (nodes * sectors + closed);  // between waves and sectors
  }
  return part;
}

}  // namespace

MachineRates machine_rates() {
  constexpr int count = 20000, repeats = 40;
  constexpr double flops_each = 24 * 8 * 2;
  const kernels::Lines values(24 * 1024);  // 192 KiB: beyond 32 or 48 KiB, within what any processor has next
  const std::size_t size = 24 * 1024;
  const double flops = count * flops_each / least_seconds([] { return in_eights<MultiplyAndAdd>(count); });
  const double bytes = repeats * size * size_of / least_seconds([&] {
                         double sum = 0;
                         for (int i = 0; i < repeats; ++i)
                           sum += in_eights<AddAll>(values.data() + 64 * (i % 2), size - 64);
                         return sum;
                       });
  return {flops, bytes};
}

double StepPart::least(const MachineRates& rates) const {
  return 1e6 * std::max(bytes / rates.bytes, flops / rates.flops);
}

StepCount count_step(const RotorAtSpeed& rotor, int sectors, double closed) {
  StepCount count;
  count.waves = waves_part(rotor, sectors, closed);
  const double nodes = static_cast<double>(sectors) * static_cast<double>(rotor.waves[0].normal_rows.rows());
  count.contact.bytes = size_of * closed * (nodes + closed / 2);
  count.contact.flops = 2 * closed * (nodes + closed);
  return count;
}

}  // namespace tiprub::simulate::testing
