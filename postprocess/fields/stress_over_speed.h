// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "cases/program/progress.h"
#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_peak.h"
#include "postprocess/fields/field_recovery.h"
#include "postprocess/fields/sector_stress.h"
#include "reduce/model/fields_file.h"

namespace tiprub::postprocess {

/// The nodes of the body with the largest stress of the vibration.
std::vector<int> stressed_nodes(const CycleStress& stress, const StressZones& zones);

/// The node of the body with the largest stress of the vibration and, with strengths, that with the largest
/// utilisation by Goodman's rule, if the vibration alternates and the spin is the mean.
std::vector<int> governing_nodes(const CycleStress& stress, const StressZones& zones,
                                 const std::optional<MaterialStrength>& strength);

/// [Pa] The largest von Mises stress of the vibration at each of some nodes, for every speed of the response, in its
/// order; nodes x speeds.
///
/// The response holds the cycles of the whole rotor only at critical speeds, but the motion of the contact dofs at
/// all of them. That motion is a sum of waves c e^{i (k Omega t + n j alpha)}. The generalized dofs g of each wave
/// follow by dynamic condensation, with the blocks of the nodal diameter's matrices and omega = k Omega,
///
///     ((1 + i eta) K_gg - omega^2 M_gg) g = -(K_gc - omega^2 M_gc) c,
///
/// where g is sought in the lowest modes of the rotor with blocked contact dofs. The loss factor eta bounds g where
/// omega meets one of their frequencies; elsewhere it hardly matters. Waves above the resolved frequency, and those
/// that hardly move, are left out. The stress of the sum is exact at the instants that are looked at: some for each
/// period of the highest wave, over the recorded revolutions.
///
/// The estimate is low where the largest stress lies at another node. `nodes`: ascending, each once; without any, the
/// result is empty.
Eigen::MatrixXd stress_over_speed(const FieldsReader& reader, const Study& study, const std::vector<int>& nodes);

/// What is known of the stress at every speed of a response, also between those whose cycles are recovered.
struct EstimatedStress {
  Eigen::VectorXd vibration;  ///< [Pa] the largest of stress_over_speed(); empty if no speed has states
  /// [1] Goodman's utilisation, with that stress as the alternating one and that of the spin as the mean, at the same
  /// nodes; empty without strengths.
  Eigen::VectorXd utilisation;
};

/// Indices of some speeds with a snapshot, at even distances.
std::vector<std::size_t> speeds_between(const Study& study);

/// The nodes that govern at the instants of speeds_between().
std::vector<int> nodes_between(const Study& study, const StressZones& zones,
                               const std::optional<MaterialStrength>& strength, const SectorStress& on_sector,
                               Progress& progress);

/// `nodes`: where the stress is read, ascending. `spin`: at the highest speed; its stress grows with the square.
EstimatedStress estimated_stress(const FieldsReader& reader, const Study& study, const std::vector<int>& nodes,
                                 const WaveField& spin, const std::optional<MaterialStrength>& strength);

}  // namespace tiprub::postprocess
