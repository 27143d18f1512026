// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "postprocess/fields/field_recovery.h"

namespace tiprub {

/// The largest values on the wheel at the instant of the largest contact force of one speed.
struct FieldPeak {
  double speed = 0;                                 ///< [rad/s]
  double displacement = 0;                          ///< [m] of the vibration
  double vibration = 0;                             ///< [Pa] von Mises stress of the vibration alone
  double spin = 0;                                  ///< [Pa] of the static shape under spin alone
  double both = 0;                                  ///< [Pa] of their sum
  int sector = 0;                                   ///< where the vibration's is largest
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< [m, rad, m] r, theta, z of that node in its sector
  std::string part;                                 ///< volume group that it belongs to; empty without groups
};

FieldPeak field_peak(const SectorFields& sector, double speed, const WheelField& vibration, const WheelField& spin);

}  // namespace tiprub
