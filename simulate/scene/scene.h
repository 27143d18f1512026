// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub::simulate {

/// The nodal diameters, sectors and samples that a scene needs. Turning it by 2 pi / g, with g = gcd(N, N_l), maps
/// the scene onto itself at every instant. From rest, therefore, only nodal diameters n that are multiples of g
/// move, because N p +- n = k N_l has solutions in whole p and k for these only (the paper's eq. 17), and N/g
/// sectors are independent. This is exact, also for the transient.
struct SceneScope {
  int symmetry = 1;                  ///< g; 1 if all nodal diameters are asked for
  int independent_sectors = 1;       ///< N / g
  std::vector<int> nodal_diameters;  ///< ascending
  int samples_per_revolution = 1;    ///< a multiple of lcm(N, lobes)
  std::vector<std::string> reasons;  ///< one line for each choice
};

/// lcm(N, lobes): after that part of a revolution, a wheel with its sectors relabelled meets the same casing again.
int symmetric_maps_per_revolution(int sector_count, int lobes);

/// The number of sectors by which the wheel must be relabelled after 1/lcm(N, lobes) of a revolution to meet the same
/// casing again: the s in 0 .. N/g - 1 with s (lobes/g) = 1 mod N/g, g = gcd(N, lobes).
int sector_shift(int sector_count, int lobes);

SceneScope find_scope(int sector_count, int lobes, const SimulateParameters& parameters);

/// The smallest multiple of the samples in a revolution that resolves the first frequency [Hz] at a speed [rad/s].
/// The phase of the casing then follows from the index of the step, and sector shifts and Fourier bins are exact.
/// Raises NoMotion if marching this speed would take more than ten minutes.
int steps_per_revolution(const SceneScope& scope, const SimulateParameters& parameters, double first_frequency,
                         double speed);

/// The data that all speeds of a sweep share.
struct Scene {
  const ReducedModel& model;
  const Casing& casing;
  const SimulateParameters& parameters;
  const SceneScope& scope;
  const ReducedModel* other_model = nullptr;  ///< of the same wheel, for error budgets; none if null
};

/// [m] Amplitude plus clearance, the length with which motions of a scene are compared.
inline double length_scale(const Scene& scene) {
  return scene.casing.amplitude + scene.casing.given_clearance(scene.model.contact).maxCoeff();
}

}  // namespace tiprub::simulate
