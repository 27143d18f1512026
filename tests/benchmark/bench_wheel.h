// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"
#include "simulate/scene/casing.h"
#include "simulate/scene/simulate_parameters.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::testing {

/// A model and a casing that it rubs hard, at a speed.
struct BenchWheel {
  std::string name;
  ReducedModel model;
  Casing casing;   ///< crests reach over the clearance
  double speed;    ///< [rad/s]
  double damping;  ///< [1] of critical, every mode
};

/// First family near 900 Hz; made up, always the same. By default 900 dofs: 10 sectors with 10 contact nodes each.
/// `tip_share` of the contact dofs' mass is left.
BenchWheel made_wheel(int lobes, double tip_share = 0.04, const WheelPlan& plan = {10, 10, 60});
/// A model.h5 under the demo's casing. Raises RunError if it can't be read.
BenchWheel given_wheel(const std::string& path, int lobes);

/// How long a speed may take to settle.
struct Patience {
  int min_revolutions, max_revolutions;
  int recorded_revolutions;  ///< of a motion that doesn't settle; of a settled one, one period
  double settle_tolerance;
};
/// The default scheme and step, with what all benchmarks have in common.
SimulateParameters bench_parameters(const BenchWheel& wheel, const Patience& patience);
/// One speed [rad/s] from rest.
SpeedResponse run_speed(const BenchWheel& wheel, const SimulateParameters& parameters, double speed);

/// All nodal diameters, or those that the casing's orders can move.
std::vector<int> nodal_diameters(const BenchWheel& wheel, int symmetry);

/// [s] of this thread's processor; the machine's other users don't count.
double cpu_seconds();

}  // namespace tiprub::simulate::testing
