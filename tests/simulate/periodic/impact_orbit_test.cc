// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "simulate/speed/speed_run.h"
#include "tests/simulate/periodic/rebounding_mass.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

struct Plan {
  explicit Plan(double at) : speed(at) {}
  double speed;             ///< [rad/s] Omega
  double frequency = 1000;  ///< [rad/s] of the mass
  double damping = 0.02;    ///< [1]
  double amplitude = 1e-3;  ///< [m] a
  double clearance = 2e-4;  ///< [m] c
};

/// One mass on a spring against an oscillating stop w(t) = c - a cos(Omega t), without rebound, in closed form. On
/// the stop it moves as that does, and leaves where m w'' + c w' + k w changes sign; then it swings freely until it
/// meets the stop again. Where it is pressed from there until the next place of leaving, that is its orbit, whatever
/// came before: its multipliers are 0.
struct BouncingMass : Plan {
  double period = two_pi / speed;
  double leaves = 0, meets = 0;  ///< [s]

  explicit BouncingMass(double at) : Plan(at) {
    constexpr int looks = 20000;
    for (int i = 0; i < looks && leaves == 0; ++i) {
      const double from = period * (double(i) / looks - 0.5), to = from + period / looks;
      if (force(from) > 0 && force(to) <= 0) leaves = bisect(from, to, [&](double t) { return force(t) > 0; });
    }
    for (int i = 1; meets == 0; ++i) {
      const double from = leaves + period * i / looks, to = from + period / looks;
      if (gap(to) < 0) meets = bisect(from, to, [&](double t) { return gap(t) > 0; });
    }
  }

  double stop(double t) const { return clearance - amplitude * std::cos(speed * t); }
  /// [N/kg] of the stop on the mass, if it moves with the stop.
  double force(double t) const {
    const double swing = amplitude * std::cos(speed * t), velocity = amplitude * speed * std::sin(speed * t);
    return -(speed * speed * swing + 2 * damping * frequency * velocity + frequency * frequency * stop(t));
  }
  double free_flight(double t) const {
    const double decay = damping * frequency, damped = frequency * std::sqrt(1 - damping * damping);
    const double start = stop(leaves), velocity = amplitude * speed * std::sin(speed * leaves), past = t - leaves;
    return std::exp(-decay * past) *
           (start * std::cos(damped * past) + (velocity + decay * start) / damped * std::sin(damped * past));
  }
  double gap(double t) const { return stop(t) - free_flight(t); }
  /// [m] of the orbit.
  double displacement(double t) const {
    const double orbit = revolutions() * period, since = t - leaves;
    t -= std::floor(since / orbit) * orbit;
    return t < meets ? free_flight(t) : stop(t);
  }
  /// Of the orbit, in revolutions; 0 if it isn't pressed when it meets the stop.
  int revolutions() const { return force(meets) > 0 ? static_cast<int>(std::ceil((meets - leaves) / period)) : 0; }
  /// [m] half of the peak-to-peak displacement, of so many samples a revolution.
  double swing(int samples) const {
    double low = 1, high = -1;
    for (int i = 0; i < samples * revolutions(); ++i) {
      const double u = displacement(period * i / samples);
      low = std::min(low, u);
      high = std::max(high, u);
    }
    return (high - low) / 2;
  }

 private:
  template <class Before>
  static double bisect(double from, double to, const Before& before) {
    for (int i = 0; i < 60; ++i) {
      const double half = (from + to) / 2;
      (before(half) ? from : to) = half;
    }
    return from;
  }
};

constexpr int samples = 240;

SpeedResponse found(const Plan& mass, int steps) {
  const ReducedModel model = testing::one_mass_along_the_stop(mass.frequency);
  const Casing casing = testing::lobed_casing(1, mass.amplitude, mass.clearance);
  SimulateParameters parameters;
  parameters.damping = {mass.damping};
  parameters.samples_per_revolution = samples;
  parameters.recorded_revolutions = 2;
  parameters.min_revolutions = 20;
  parameters.max_revolutions = 200;
  parameters.settle_tolerance = 1e-6;
  parameters.casing_areas = 1;
  parameters.steady_state = SteadyStateMethod::orbit;
  parameters.steps_per_revolution = steps;
  const SceneScope scope = find_scope(1, 1, parameters);
  return simulate_speed({model, casing, parameters, scope}, mass.speed).response;
}

constexpr double one_revolution = 1200, two_revolutions = 3200;  // rad/s

TEST(ImpactOrbit, IsThatOfTheClosedForm) {
  for (const double speed : {one_revolution, two_revolutions}) {
    const BouncingMass mass(speed);
    ASSERT_EQ(mass.revolutions(), speed == one_revolution ? 1 : 2);
    std::vector<double> errors;
    for (const int steps : {2400, 9600}) {
      const SpeedResponse orbit = found(mass, steps);
      ASSERT_EQ(orbit.audit.orbit.outcome, OrbitReport::Outcome::found) << speed;
      EXPECT_EQ(orbit.period_beats, mass.revolutions());
      EXPECT_EQ(orbit.audit.orbit.maps, mass.revolutions());
      EXPECT_LT(orbit.audit.orbit.multiplier, 1e-6) << "the closed form's 0: all is forgotten on the stop";
      errors.push_back(std::abs(orbit.amplitude / mass.swing(samples) - 1));
    }
    EXPECT_LT(errors[0], 1e-6);
    EXPECT_LT(errors[1], errors[0] / 4);
  }
}

/// Symptom once: with four million steps a revolution the orbit was 2e-6 off, more than with ten thousand: rounding
/// had taken the velocity's digits, which were the difference of two positions.
TEST(ImpactOrbit, KeepsItsDigitsAtTinySteps) {
  constexpr int steps = 4'000'000, stride = 1000;
  const BouncingMass mass(one_revolution);
  testing::Bench bench = testing::make_bench(
      testing::one_mass_along_the_stop(mass.frequency), testing::lobed_casing(1, mass.amplitude, mass.clearance),
      mass.speed, mass.damping, {Scheme::trigonometric, ContactRule::complementarity, steps, 1});
  bench.march.set_step(8LL * steps);  // the casing is grown
  for (int i = 0; i < steps; ++i) bench.march.step();
  double error = 0;
  for (int i = 0; i < steps; ++i, bench.march.step())
    if (i % stride == 0)
      error = std::max(error, std::abs(bench.march.displacement()[0] - mass.displacement(mass.period * i / steps)));
  EXPECT_LT(error, 1e-9 * mass.amplitude);
}

/// Symptom once: impacts were locked to the instants of the grid. Their multipliers were 0 at every step, and orbits
/// were of first order.
TEST(ImpactOrbit, LeavesAtOnceAsTheReturnMapSays) {
  for (const auto& [clearance, speed] :
       {std::pair(2e-4, 1040.0), std::pair(9e-4, 1340.0), std::pair(2e-4, 2400.0), std::pair(2e-4, 2560.0)}) {
    const testing::ReboundingMass mass{1000, 0.02, 1e-3, clearance};
    const testing::ReboundingOrbit exact = rebounding_orbit(mass, speed, testing::Half::attracting);
    ASSERT_LT(exact.force, 0) << "it leaves at once";
    std::vector<double> errors;
    for (const int steps : {240, 960}) {
      Plan plan(speed);
      plan.clearance = clearance;
      const SpeedResponse orbit = found(plan, steps);
      ASSERT_EQ(orbit.audit.orbit.outcome, OrbitReport::Outcome::found) << speed;
      EXPECT_EQ(orbit.audit.orbit.maps, 1);
      EXPECT_NEAR(orbit.audit.orbit.multiplier / std::abs(exact.multiplier), 1, 2e-3) << speed << ", " << steps;
      EXPECT_LT(std::abs(orbit.energy.closing_error), 1e-10);
      errors.push_back(std::abs(orbit.amplitude / exact.swing(samples) - 1));
    }
    Plan by_default(speed);
    by_default.clearance = clearance;
    EXPECT_NEAR(found(by_default, 0).audit.orbit.multiplier / std::abs(exact.multiplier), 1, 1e-2) << speed;
    EXPECT_LT(errors[0], 1e-5) << speed;
    EXPECT_LT(errors[1], errors[0] / 4 + 1e-8) << speed;
  }
}

/// [rad/s] where the flight of two revolutions just touches the stop half-way.
double grazing_speed() {
  double low = 2800, high = two_revolutions;
  while (high - low > 1e-6) {
    const double half = (low + high) / 2;
    (BouncingMass(half).revolutions() == 2 ? high : low) = half;
  }
  return high;
}

/// How often a motion meets the stop in its period.
int meetings(const SpeedResponse& orbit) {
  int count = 0;
  const Eigen::Index last = orbit.contact_force.rows() - 1;
  for (Eigen::Index i = 0; i <= last; ++i)
    count += orbit.contact_force(i, 0) > 0 && !(orbit.contact_force(i > 0 ? i - 1 : last, 0) > 0);
  return count;
}

TEST(ImpactOrbit, GrazesWhereTheClosedFormDoes) {
  const double grazing = grazing_speed();
  for (const double beside : {-1e-3, 1e-3}) {
    const SpeedResponse orbit = found(BouncingMass(grazing * (1 + beside)), 10000);
    ASSERT_EQ(orbit.audit.orbit.outcome, OrbitReport::Outcome::found);
    EXPECT_EQ(orbit.period_beats, 2);
    EXPECT_EQ(meetings(orbit), beside < 0 ? 2 : 1) << beside;
  }
}

}  // namespace
}  // namespace tiprub::simulate
