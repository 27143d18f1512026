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

/// The states of a nodal diameter at some samples, as sums of a few states: a motion has far fewer than its model has
/// dofs or its cycle has samples.
struct FewStates {
  Eigen::MatrixXcd basis;         ///< dofs x few
  Eigen::MatrixXcd coefficients;  ///< few x samples
};
/// By nodal diameter, of `count` samples from the first on.
std::vector<FewStates> few_states(const WheelCycle& cycle, Eigen::Index first, Eigen::Index count);
/// How many fields all of them need.
int fields_of(const std::vector<FewStates>& few);

/// Waves of a nodal diameter at some samples: sums of a few fields.
struct SampledWaves {
  std::vector<WaveField> fields;
  Eigen::MatrixXcd coefficients;  ///< fields x samples
};
/// `waves`: at all samples of the cycle, by nodal diameter.
CycleStress cycle_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count,
                         const std::vector<SampledWaves>& waves);

/// Recovers waves with their stress, one for each column of states; `diameter` is an index into SimulatedScene's.
using WaveRecovery = std::function<std::vector<WaveField>(std::size_t diameter, const Eigen::MatrixXcd& states)>;

/// The same of a cycle whose fields may be more than the memory holds: at most `most_fields` (or one sample's) are
/// recovered at a time. `progress` advances with each sample.
CycleStress cycle_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count, const WaveRecovery& recover,
                         int most_fields, Progress& progress);

}  // namespace tiprub::postprocess
