// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/model/reduced_model.h"
#include "simulate/scene/casing.h"

namespace tiprub {

/// What the tips meet at one speed: the casing, as the tips see it. It is rigid and stands still around the wheel, so
/// that a gap depends on a tip's place and on time alone; one that gives way would add its compliance to the tips'.
class Obstacle {
 public:
  /// `clearance` [m]: at the tips of the tightest blade, at this speed.
  Obstacle(const Casing& casing, const ContactLine& tips, Eigen::VectorXd clearance);
  /// A casing without lobes that all tips touch: gaps are displacements.
  Obstacle touching() const;

  /// N_l: the same obstacle after every 2 pi / N_l.
  int lobes() const { return casing_.lobes; }
  /// [m] between the tips of the tightest blade, and of a sector's blade, and the undistorted casing.
  const Eigen::VectorXd& clearance() const { return clearance_; }
  Eigen::VectorXd clearance(int sector) const { return clearance_.array() + casing_.extra_clearance(sector); }
  /// [m] by which the casing, fully grown, stands inward over a tip of sector 0 that has turned by an angle in rad.
  double distortion(int tip, double turn) const { return casing_.distortion(angle_[tip] + turn, fraction_[tip]); }
  /// Factor of the distortion after so many revolutions.
  double grown(double revolutions) const { return casing_.ramp(revolutions); }

 private:
  Casing casing_;
  Eigen::VectorXd angle_;     ///< [rad] of the tips of sector 0
  Eigen::VectorXd fraction_;  ///< [1] of the tips' arc length
  Eigen::VectorXd clearance_;
};

}  // namespace tiprub
