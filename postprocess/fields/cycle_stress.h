// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "cases/program/progress.h"
#include "postprocess/fields/field_recovery.h"
#include "postprocess/fields/wheel_cycle.h"

namespace tiprub::postprocess {

/// The largest von Mises stress at every node of a sector over all samples and all sectors of a cycle.
struct CycleStress {
  Eigen::VectorXd vibration;       ///< [Pa] of the vibration alone
  Eigen::VectorXd spin;            ///< [Pa] of the static shape under spin alone
  Eigen::VectorXd both;            ///< [Pa] of their sum
  Eigen::VectorXi sector, sample;  ///< where and when that of the vibration is largest; the recorded sample
  /// [Pa] Von Mises stress of the mean tensor over the cycle, spin included, and the largest one of the tensor minus
  /// that mean; nodes x blades with different histories (WheelCycle::histories()). Empty if there is only an instant.
  Eigen::MatrixXd mean, alternating;
  Eigen::VectorXd displacement;  ///< [m] the farthest that a node moves by vibration
};

/// Recovers waves with their stress, one for each column of states; `diameter` is an index into SimulatedScene's.
using WaveRecovery = std::function<std::vector<WaveField>(std::size_t diameter, const Eigen::MatrixXcd& states)>;

/// Recovers the cycle's samples as sums of a few fields, at most `most_fields` (or one sample's) at a time to bound
/// the memory. `progress` advances with each sample.
CycleStress cycle_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count, const WaveRecovery& recover,
                         int most_fields, Progress& progress);

}  // namespace tiprub::postprocess
