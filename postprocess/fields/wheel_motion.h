// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub {

/// One travelling wave of the whole rotor: sector j moves by Re(x e^{i (k phi + n j alpha)}), phi the rotor's angle
/// from the start of the recording, k = engine_order, of either sign.
struct RotorWave {
  int nodal_diameter = 0;   ///< n, 0 .. N/2
  double engine_order = 0;  ///< k; 0: at rest in the rotor
  double share = 0;         ///< [1] of the motion's mean square, weighted by mass
  Eigen::VectorXcd state;   ///< x, in the model's dofs [m in contact rows]
};

/// The rotor's motion over a cycle as its largest waves: some numbers a node for all instants.
struct WheelMotion {
  int first_sample = 0;          ///< of the recorded ones: the cycle's
  int samples = 0;               ///< in the cycle, to the end of the recording
  std::vector<RotorWave> waves;  ///< the largest first
  double left_out = 0;           ///< [1] share of the mean square in the waves that are not among these
};

/// Waves that make up all but `left_out` of the motion of a speed that has a cycle, `most` at most. The Fourier
/// series of the model's states over whole revolutions.
WheelMotion wheel_motion(const SpeedResponse& response, const SimulatedScene& scene, const ReducedModel& model,
                         double left_out, std::size_t most);

}  // namespace tiprub
