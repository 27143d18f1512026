// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/scheme_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include "simulate/march/rotor_at_speed.h"
#include "tests/benchmark/benchmarks.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double margin = 1.15;  // of the step at the limit of central differences
constexpr int areas = 60;
constexpr double agreeing_share = 0.95;
constexpr double damping_beyond = 0.02;  // of critical, above what the mesh resolves: as a case has it

/// 24 revolutions of a motion that doesn't repeat, for its averages.
SpeedResponse run(const BenchWheel& wheel, double speed, Scheme scheme, int steps) {
  SimulateParameters parameters = bench_parameters(wheel, {20, 120, 24, 1e-4});
  parameters.scheme = scheme;
  parameters.steps_per_revolution = steps;
  parameters.casing_areas = areas;
  parameters.resolved_frequency = 0;
  parameters.damping_ratio_beyond = damping_beyond;
  fit_to_model(parameters, wheel.model);
  return run_speed(wheel, parameters, speed);
}

int central_steps(const BenchWheel& wheel, double speed) {
  const int symmetry = std::gcd(wheel.model.sector_count, wheel.casing.lobes);
  const RotorAtSpeed rotor = rotor_at_speed(wheel.model, speed, nodal_diameters(wheel, symmetry), {wheel.damping});
  return static_cast<int>(std::ceil(margin * std::numbers::pi * rotor.omega_max / speed));
}

/// [m] half of peak to peak, of the dof that moves most; mean over the recorded revolutions.
double amplitude(const SpeedResponse& at) {
  double sum = 0;
  for (int r = 0; r < at.recorded_revolutions; ++r) {
    const Eigen::Index samples = at.samples_per_revolution;
    const auto rows = at.displacement.middleRows(r * samples, samples);
    sum += 0.5 * (rows.colwise().maxCoeff() - rows.colwise().minCoeff()).maxCoeff();
  }
  return sum / at.recorded_revolutions;
}

double overlap(const SpeedResponse& here, const SpeedResponse& there) {
  const Eigen::MatrixXd a = here.contact_count.cast<double>(), b = there.contact_count.cast<double>();
  if (!(a.sum() > 0) || !(b.sum() > 0)) return a.sum() == b.sum() ? 1.0 : 0.0;
  return (a / a.sum()).cwiseMin(b / b.sum()).sum();
}

}  // namespace

bool SchemePair::agree() const {
  return trigonometric.failure.empty() && central.failure.empty() && amplitude_difference <= same_amplitude &&
         pattern_overlap >= same_pattern;
}

std::string class_of(const SpeedResponse& at) {
  if (!at.failure.empty()) return "failed";
  if (at.motion != MotionClass::subharmonic) return name_of(at.motion);
  return "subharmonic 1/" + std::to_string(at.period_beats);
}

std::vector<SchemePair> compare_schemes(const BenchWheel& wheel, double slowest, double fastest, int count) {
  std::vector<SchemePair> pairs;
  for (int i = 0; i < count; ++i) {
    SchemePair pair;
    pair.speed = slowest + (fastest - slowest) * i / (count - 1);
    pair.trigonometric = run(wheel, pair.speed, Scheme::trigonometric, 0);
    pair.central = run(wheel, pair.speed, Scheme::central_differences, central_steps(wheel, pair.speed));
    if (pair.trigonometric.failure.empty() && pair.central.failure.empty()) {
      pair.amplitude_difference = std::abs(amplitude(pair.trigonometric) / amplitude(pair.central) - 1);
      pair.pattern_overlap = overlap(pair.trigonometric, pair.central);
    }
    for (SpeedResponse* at : {&pair.trigonometric, &pair.central}) {
      at->displacement.resize(0, 0);
      at->contact_force.resize(0, 0);
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

bool print_scheme_agreement(const std::string& model, int speeds) {
  const BenchWheel wheel = model.empty() ? made_wheel(2) : given_wheel(model, 2);
  std::printf("# %s against two lobes: trigonometric and central differences\n", wheel.name.c_str());
  std::printf("# rad/s\tsteps\tsteps\tclass\tclass\tamplitude differs by\tcontact maps overlap by\tagree\n");
  const std::vector<SchemePair> pairs = compare_schemes(wheel, 0.4 * wheel.speed, 2 * wheel.speed, speeds);
  for (const SchemePair& at : pairs)
    std::printf("%.1f\t%d\t%d\t%s\t%s\t%.2e\t%.3f\t%s\n", at.speed, at.trigonometric.steps_per_revolution,
                at.central.steps_per_revolution, class_of(at.trigonometric).c_str(), class_of(at.central).c_str(),
                at.amplitude_difference, at.pattern_overlap, at.agree() ? "yes" : "no");
  const auto agreeing = std::count_if(pairs.begin(), pairs.end(), [](const SchemePair& at) { return at.agree(); });
  const auto alike = std::count_if(pairs.begin(), pairs.end(), [](const SchemePair& at) {
    return class_of(at.trigonometric) == class_of(at.central);
  });
  std::printf("# %d of %d speeds agree: amplitude within %g, overlap at least %g; %d have the same class\n",
              static_cast<int>(agreeing), speeds, same_amplitude, same_pattern, static_cast<int>(alike));
  return static_cast<double>(std::min(agreeing, alike)) >= agreeing_share * speeds;
}

}  // namespace tiprub::simulate::testing
