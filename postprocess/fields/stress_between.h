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
