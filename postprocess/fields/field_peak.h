// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/postprocess_parameters.h"
#include "postprocess/fields/cycle_stress.h"
#include "postprocess/fields/sector_geometry.h"
#include "reduce/model/fields_file.h"

namespace tiprub::postprocess {

/// Where a sector's stress can be read, and where the exact stress is unbounded, so that the computed one grows as
/// the mesh is refined.
enum class StressZone {
  body,       ///< neither of the others
  tip_patch,  ///< near the tip lines, the splitter's only if it is in contact: the casing pushes at single nodes
  clamp_rim,  ///< near the edge of the clamped surface
};

/// The zones of a sector. Their width does not depend on the mesh, so that meshes can be compared.
struct StressZones {
  double width = 0;                 ///< [m] from the tip lines, and from the clamp's edge in the meridional plane
  std::vector<StressZone> at_node;  ///< by node of the sector
};

/// A `width` of 0 means 5 % of the tip line's length. Raises InputError if no node is left in the body.
StressZones stress_zones(const SectorFields& sector, double width);

/// [m] The length of the tip line.
double tip_length(const SectorFields& sector);

/// The first node of a zone with the largest value; -1 if the zone is empty.
Eigen::Index largest_in(StressZone zone, const StressZones& zones, const Eigen::VectorXd& values);

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
