// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>

#include "postprocess/analysis/postprocess_parameters.h"
#include "postprocess/fields/blade_place.h"
#include "postprocess/fields/cycle_stress.h"
#include "postprocess/fields/stress_zones.h"

namespace tiprub {

/// [Pa] The largest von Mises stresses of a zone, over its nodes, all sectors and all samples.
struct StressMaxima {
  double vibration = 0;  ///< of the vibration alone
  double spin = 0;       ///< of the static shape under spin alone
  double both = 0;       ///< of their sum
};

/// What a node goes through in a cycle.
struct StressCycle {
  double mean = 0;                ///< [Pa] von Mises stress of the mean tensor, spin included
  double alternating = 0;         ///< [Pa] the largest von Mises stress of the tensor minus its mean
  std::string where;              ///< in words
  std::optional<double> goodman;  ///< [1] utilisation, where the case gives strengths
};

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
  /// Outside tip patch and clamp rim, where the utilisation is largest, or else the alternating part; only of a
  /// cycle.
  std::optional<StressCycle> cycle;
  std::optional<double> yield_share;  ///< [1] body's stress of both over the yield strength, where the case gives it
};

FieldPeak field_peak(const SectorFields& sector, const CycleStress& stress, const StressZones& zones,
                     const BladePlaces& places, const std::optional<MaterialStrength>& strength);

}  // namespace tiprub
