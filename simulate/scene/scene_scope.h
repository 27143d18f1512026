// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "simulate/scene/casing.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub {

/// What this scene needs, and no more. Turning by 2 pi / g, g = gcd(N, orders of the casing), maps the scene onto
/// itself at every instant: from rest only nodal diameters that are multiples of g move, and N/g sectors are
/// independent: N alpha +- n = k N_l has solutions for these only (the paper's eq. 17). That is exact, the transient
/// included.
struct SceneScope {
  int symmetry = 1;                  ///< g; 1 if all nodal diameters are asked for
  int independent_sectors = 1;       ///< N / g
  std::vector<int> nodal_diameters;  ///< ascending
  int samples_per_revolution = 1;    ///< a multiple of lcm(N, lobes)
  std::vector<std::string> reasons;  ///< one line a choice
};

/// Sectors by which the wheel is relabelled after 1/lcm(N, lobes) of a revolution to meet the same casing again:
/// the s in 0 .. N/g - 1 with s (lobes/g) = 1 mod N/g, g = gcd(N, lobes).
int sector_shift(int sector_count, int lobes);

SceneScope find_scope(int sector_count, int lobes, const SimulateParameters& parameters);

/// The smallest multiple of the samples that resolves the first frequency [Hz] at a speed [rad/s]: the casing's phase
/// then comes from the step's index, and sector shifts and Fourier bins are exact.
/// Raises NoMotion if that takes more than ten minutes at this speed.
int steps_per_revolution(const SceneScope& scope, const SimulateParameters& parameters, double first_frequency,
                         double speed);

}  // namespace tiprub
