// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub {

/// The wheel's states over a cycle, without those that are other ones turned: a motion that travels with the casing
/// repeats itself, turned by some sectors, many times a revolution. So the stress at a few samples of all
/// independent sectors is all the stress there is.
struct WheelCycle {
  /// By nodal diameter, as SimulatedScene lists them; model dofs x samples. The state after the last of them is the
  /// first one turned, or the cycle's end.
  std::vector<Eigen::MatrixXcd> states;
  int first_sample = 0;  ///< of the recorded ones
  int turn = 0;          ///< [sectors] what sector j does after the last of the samples, sector j + turn did before
  int sectors = 0;       ///< independent ones
  bool whole = false;    ///< a cycle; if not, one instant, which has no mean
  /// Samples of the cycle for which these stand.
  int recorded_samples = 0;

  int samples() const { return static_cast<int>(states.front().cols()); }
  /// How many blades live differently: blades j and j + histories() pass through the same states, at other times.
  int histories() const;
};

/// From the cycle of a speed, or else from its snapshot, one of which must be there. States that differ by less than
/// 1e-3 of their norm (of elastic energy) are one and the same, which is far below what stress from a mesh is worth.
WheelCycle wheel_cycle(const SpeedResponse& response, const SimulatedScene& scene, const ReducedModel& model);

}  // namespace tiprub
