// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/obstacle.h"

#include <utility>

namespace tiprub {

Obstacle::Obstacle(const Casing& casing, const ContactLine& tips, Eigen::VectorXd clearance)
    : casing_(casing),
      angle_(tips.position.col(1)),
      fraction_(arc_fractions(tips)),
      clearance_(std::move(clearance)) {}

Obstacle Obstacle::touching() const {
  Obstacle level = *this;
  level.casing_.shape = CasingShape::cosine;
  level.casing_.amplitude = 0;
  level.clearance_.setZero();
  return level;
}

}  // namespace tiprub
