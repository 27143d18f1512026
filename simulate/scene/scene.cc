// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

#include "cases/program/text.h"
#include "simulate/motion/attempt.h"

namespace tiprub::simulate {

namespace {

constexpr double most_steps = 5e8;  // of one march

double rounded_up(double value, double unit) {
  return unit * std::max(1.0, std::ceil(value / unit));
}

void explain(SceneScope& scope, int sector_count, int lobes, int grid, const SimulateParameters& parameters) {
  const std::string wheel = text_of(sector_count, " sectors, ", lobes, " lobes");
  const std::string diameters =
      "nodal diameters " + listed(scope.nodal_diameters, ", ", [](int n) { return std::to_string(n); });
  if (parameters.nodal_diameters == DiameterChoice::all)
    scope.reasons.push_back(diameters + ": all, as asked for");
  else
    scope.reasons.push_back(
        text_of(diameters, ": multiples of gcd(", wheel, ") = ", scope.symmetry, "; from rest no other one moves"));
  scope.reasons.push_back(text_of("independent sectors ", scope.independent_sectors, " of ", sector_count,
                                  ": sector j moves as sector j mod ", scope.independent_sectors));
  scope.reasons.push_back(text_of("samples a revolution ", scope.samples_per_revolution, ": at least ",
                                  parameters.samples_per_revolution, ", a multiple of lcm(", wheel, ") = ", grid));
  const std::string multiple = ", a multiple of the samples";
  scope.reasons.push_back(
      parameters.steps_per_revolution > 0
          ? text_of("steps a revolution: at least ", parameters.steps_per_revolution, " as asked for", multiple)
          : text_of("steps a revolution: at least ", parameters.steps_per_period,
                    " a period of the lowest frequency, halved until that changes the motion by less than ",
                    parameters.step_tolerance, multiple, "; by speed"));
  if (parameters.steady_state == SteadyStateMethod::orbit)
    scope.reasons.push_back("settled motions: by Newton's method for a fixed point of 1/" + std::to_string(grid) +
                            " of a revolution and a shift of " + std::to_string(sector_shift(sector_count, lobes)) +
                            " sectors, which a motion that travels with the casing repeats; where there is none that "
                            "attracts, by marching" +
                            (scope.symmetry == std::gcd(sector_count, lobes)
                                 ? ""
                                 : "; not used, because all nodal diameters are asked for"));
}

}  // namespace

int symmetric_maps_per_revolution(int sector_count, int lobes) {
  return std::lcm(sector_count, lobes);
}

int sector_shift(int sector_count, int lobes) {
  const int common = std::gcd(sector_count, lobes), sectors = sector_count / common;
  int shift = 0;
  while ((shift * static_cast<std::int64_t>(lobes / common) - 1) % sectors != 0) ++shift;
  return shift;
}

SceneScope find_scope(int sector_count, int lobes, const SimulateParameters& parameters) {
  SceneScope scope;
  if (parameters.nodal_diameters == DiameterChoice::symmetric) scope.symmetry = std::gcd(sector_count, lobes);
  scope.independent_sectors = sector_count / scope.symmetry;
  // eq. 17: p N +- n = k N_l for some whole p, k
  for (int n = 0; n <= sector_count / 2; n += scope.symmetry) scope.nodal_diameters.push_back(n);
  const int grid = symmetric_maps_per_revolution(sector_count, lobes);
  const int samples = std::max(parameters.samples_per_revolution, parameters.samples_per_lobe * lobes);
  scope.samples_per_revolution = static_cast<int>(rounded_up(samples, grid));
  explain(scope, sector_count, lobes, grid, parameters);
  return scope;
}

int steps_per_revolution(const SceneScope& scope, const SimulateParameters& parameters, double first_frequency,
                         double speed) {
  const double periods = 2 * std::numbers::pi * first_frequency / speed;
  const double wanted =
      parameters.steps_per_revolution > 0 ? parameters.steps_per_revolution : parameters.steps_per_period * periods;
  const double steps = rounded_up(wanted, scope.samples_per_revolution);
  const int revolutions = std::max(1, parameters.max_revolutions);
  if (steps * revolutions > most_steps)
    throw NoMotion("may take " + text_of(steps * revolutions) + " steps (" + std::to_string(revolutions) +
                   " revolutions of " + text_of(steps) +
                   "), more than ten minutes of marching for one speed; at most " + text_of(most_steps) +
                   " are taken: raise the speed, or lower [simulate] max_revolutions or the steps");
  return static_cast<int>(steps);
}

}  // namespace tiprub::simulate
