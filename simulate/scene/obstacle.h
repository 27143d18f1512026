// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <utility>

#include "reduce/model/reduced_model.h"
#include "simulate/scene/casing.h"

namespace tiprub::simulate {

/// What the tips meet at one speed: the casing in the frame of the tips. It is rigid and stands still around the
/// wheel, so that its gap depends only on the place of a tip and on time. A flexible obstacle would add its
/// compliance to that of the tips.
class Obstacle {
 public:
  /// `clearance` [m] is that of the tightest blade at this speed, tip by tip.
  Obstacle(const Casing& casing, const ContactLine& tips, Eigen::VectorXd clearance)
      : casing_(casing),
        angle_(tips.position.col(1)),
        fraction_(arc_fractions(tips)),
        clearance_(std::move(clearance)) {}
  /// The same without lobes and clearance: gaps are then negative displacements.
  Obstacle touching() const {
    Obstacle level = *this;
    level.casing_.shape = CasingShape::cosine;
    level.casing_.amplitude = 0;
    level.clearance_.setZero();
    return level;
  }

  /// N_l; the obstacle repeats every 2 pi / N_l.
  int lobes() const { return casing_.lobes; }
  /// [m] The distance of the undistorted casing from the tips of the tightest blade, or from those of a sector.
  const Eigen::VectorXd& clearance() const { return clearance_; }
  Eigen::VectorXd clearance(int sector) const { return clearance_.array() + casing_.extra_clearance(sector); }
  /// [m] The full distortion inward over a tip of sector 0 after it has turned by an angle in rad.
  double distortion(int tip, double turn) const { return casing_.distortion(angle_[tip] + turn, fraction_[tip]); }
  /// The factor by which the distortion has grown after a number of revolutions.
  double grown(double revolutions) const { return casing_.ramp(revolutions); }

 private:
  Casing casing_;
  Eigen::VectorXd angle_;     ///< [rad] of the tips of sector 0
  Eigen::VectorXd fraction_;  ///< [1] of the tips' arc length
  Eigen::VectorXd clearance_;
};

}  // namespace tiprub::simulate
