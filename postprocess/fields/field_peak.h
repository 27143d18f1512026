// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/progress.h"
#include "postprocess/analysis/postprocess_parameters.h"
#include "postprocess/fields/blade_place.h"
#include "postprocess/fields/field_recovery.h"
#include "postprocess/fields/wheel_cycle.h"
#include "reduce/model/fields_file.h"

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
  double displacement = 0;  ///< [m] the farthest that any node moves by vibration
};

/// Recovers waves with their stress, one for each column of states; `diameter` is an index into SimulatedScene's.
using WaveRecovery = std::function<std::vector<WaveField>(std::size_t diameter, const Eigen::MatrixXcd& states)>;

/// Recovers the cycle's samples as sums of a few fields, at most `most_fields` (or one sample's) at a time to bound
/// the memory. `progress` advances with each sample.
CycleStress cycle_stress(const WheelCycle& cycle, const Tensors& spin, int sector_count, const WaveRecovery& recover,
                         int most_fields, Progress& progress);

/// Where a sector's stress can be read, and where the exact stress is unbounded, so that the computed one grows as
/// the mesh is refined.
enum class StressZone {
  body,       ///< neither of the others
  tip_patch,  ///< near the tip line: the casing pushes at single nodes
  clamp_rim,  ///< near the edge of the clamped surface
};

/// The zones of a sector. Their lengths do not depend on the mesh, so that meshes can be compared.
struct StressZones {
  double tip_patch = 0;             ///< [m] from the line through the contact nodes
  double clamp_rim = 0;             ///< [m] from the clamp's edge, in the meridional plane
  std::vector<StressZone> at_node;  ///< by node of the sector
};

/// `tip_patch` [m] also is the width of the clamp's rim; 0 means 5 % of the tip line's length. Raises InputError if
/// no node is left in the body.
StressZones stress_zones(const SectorFields& sector, double tip_patch);

/// [m] The length of the tip line.
double tip_length(const SectorFields& sector);

/// [Pa] The largest von Mises stresses over a zone's nodes, all sectors and all samples.
struct StressMaxima {
  double vibration = 0;  ///< of the vibration alone
  double spin = 0;       ///< of the static shape under spin alone
  double both = 0;       ///< of their sum
};

/// The stress of a node over a cycle.
struct StressCycle {
  double mean = 0;                ///< [Pa] von Mises stress of the mean tensor, spin included
  double alternating = 0;         ///< [Pa] the largest von Mises stress of the tensor minus its mean
  std::string where;              ///< in words
  std::optional<double> goodman;  ///< [1] utilisation, where the case gives strengths
  std::optional<MaterialStrength> strength;
};

/// [Pa] The alternating stress at which the utilisation is 1 with the mean of a cycle that has one; 0 if the mean
/// alone reaches it.
double allowed_alternating(const StressCycle& cycle);

/// The stress of one speed, over its cycle, or at its snapshot where the response has no cycle.
struct FieldPeak {
  double speed = 0;         ///< [rad/s]
  double displacement = 0;  ///< [m] the farthest that a node moves by vibration
  StressMaxima body, tip_patch, clamp_rim;
  int sector = 0;                                   ///< where the body's vibration is largest
  int sample = 0;                                   ///< and when: of the recorded ones
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< [m, rad, m] r, theta, z of that node in its sector
  std::string part;                                 ///< volume group that it belongs to; empty without groups
  std::string where;                                ///< in words
  int samples = 0;                                  ///< of the cycle; 0: only a snapshot
  /// Where, in the body, the utilisation is largest (the alternating part, if the case gives no strengths); only of a
  /// cycle.
  std::optional<StressCycle> cycle;
  std::optional<double> yield_share;  ///< [1] the body's stress of both over the yield strength, if given
};

FieldPeak field_peak(const SectorFields& sector, const CycleStress& stress, const StressZones& zones,
                     const BladePlaces& places, const std::optional<MaterialStrength>& strength);

}  // namespace tiprub::postprocess
