// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/reduced_model.h"
#include "simulate/casing.h"

namespace tiprub::bench {

/// A model and a casing that it rubs hard, at a speed.
struct BenchWheel {
  std::string name;
  ReducedModel model;
  Casing casing;   ///< crests reach over the clearance
  double speed;    ///< [rad/s]
  double damping;  ///< [1] of critical, every mode
};

/// 900 dofs: 10 sectors, 10 contact nodes each, first family near 900 Hz; made up, always the same.
BenchWheel made_wheel(int lobes);
/// A model.h5 under the demo's casing. Raises RunError if it can't be read.
BenchWheel given_wheel(const std::string& path, int lobes);

/// All nodal diameters, or those that the casing's orders can move.
std::vector<int> nodal_diameters(const BenchWheel& wheel, int symmetry);

/// [s] of this thread's processor; the machine's other users don't count.
double cpu_seconds();

}  // namespace tiprub::bench
