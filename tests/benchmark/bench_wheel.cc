// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/bench_wheel.h"

#include <algorithm>
#include <ctime>
#include <numbers>
#include <utility>

#include "reduce/model/reduced_model_file.h"
#include "simulate/speed/speed_run.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

}  // namespace

BenchWheel made_wheel(int lobes, double tip_share, const WheelPlan& plan) {
  constexpr double first_frequency = 900, speed = 1000;
  const int dofs = plan.sectors * (3 * plan.contact_nodes + plan.generalized);
  BenchWheel wheel{"made, " + std::to_string(dofs) + " dofs", testing::synthetic_wheel(plan),
                   testing::lobed_casing(lobes, 3e-4, 1.5e-4), speed, 0.005};
  // light tips, as static shapes of contact dofs have them: they make omega_max, and the step of central differences
  for (NodalDiameterModel& at : wheel.model.nodal_diameters) {
    at.M.topRows(wheel.model.contact_dofs()) *= tip_share;
    at.M.leftCols(wheel.model.contact_dofs()) *= tip_share;
  }
  // stiffnesses scaled so that the lowest frequency is the wanted one: the random wheel is what it is
  double lowest = 1e300;
  for (const NodalDiameterModel& at : wheel.model.nodal_diameters)
    lowest = std::min(lowest, at.natural_frequencies(0)[0]);
  const double factor = first_frequency * first_frequency / (lowest * lowest);
  for (NodalDiameterModel& at : wheel.model.nodal_diameters)
    for (Eigen::MatrixXcd& term : at.K.terms) term *= factor;
  return wheel;
}

BenchWheel given_wheel(const std::string& path, int lobes) {
  Casing casing = testing::lobed_casing(lobes, 0.15e-3, 0.125e-3);
  casing.clearance = {{0.0, 0.13e-3}, {1.0, 0.12e-3}};
  casing.ramp_revolutions = 3;
  ReducedModel model = read_model(path);
  const double speed = std::min(24375 * two_pi / 60, model.speed_max);
  return {path, std::move(model), casing, speed, 0.01};
}

SimulateParameters bench_parameters(const BenchWheel& wheel, const Patience& patience) {
  SimulateParameters parameters;
  parameters.damping = {wheel.damping};
  parameters.samples_per_revolution = 240;
  parameters.min_revolutions = patience.min_revolutions;
  parameters.max_revolutions = patience.max_revolutions;
  parameters.recorded_revolutions = patience.recorded_revolutions;
  parameters.settle_tolerance = patience.settle_tolerance;
  parameters.casing_areas = 1;
  return parameters;
}

SpeedResponse run_speed(const BenchWheel& wheel, const SimulateParameters& parameters, double speed) {
  const SceneScope scope = find_scope(wheel.model.sector_count, wheel.casing.lobes, parameters);
  return simulate_speed({wheel.model, wheel.casing, parameters, scope}, speed).response;
}

std::vector<int> nodal_diameters(const BenchWheel& wheel, int symmetry) {
  std::vector<int> held;
  for (int n = 0; n <= wheel.model.nodal_diameter_max(); n += symmetry) held.push_back(n);
  return held;
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace tiprub::simulate::testing
