// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "cases/program/progress.h"
#include "postprocess/fields/field_recovery.h"
#include "postprocess/fields/wheel_cycle.h"

namespace tiprub {

/// Von Mises stress at every node of a sector, the largest over all samples and all sectors of a cycle.
struct CycleStress {
  Eigen::VectorXd vibration;       ///< [Pa] of the vibration alone
  Eigen::VectorXd spin;            ///< [Pa] of the static shape under spin alone
  Eigen::VectorXd both;            ///< [Pa] of their sum
  Eigen::VectorXi sector, sample;  ///< where and when the vibration's is largest; the sample of the recorded ones
  /// [Pa] of the mean tensor over the cycle, spin included, and the largest of the tensor minus that mean; nodes x
  /// blades that live differently (WheelCycle::histories()). Empty if there is only an instant.
  Eigen::MatrixXd mean, alternating;
  double displacement = 0;  ///< [m] the farthest that any node moves by vibration
};

/// Waves with their stress, one a column of states of a nodal diameter (the index into SimulatedScene's).
using WaveRecovery = std::function<std::vector<WaveField>(std::size_t diameter, const Eigen::MatrixXcd& states)>;

/// Costs the recovery of each of the cycle's samples once; takes as much memory as `block` samples of the recovered
/// waves, at least one. `progress` advances by each sample.
CycleStress cycle_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count, const WaveRecovery& recover,
                         int block, Progress& progress);

}  // namespace tiprub
