// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace tiprub {

/// The motion of a wheel at an instant on whole revolutions, in the model's coordinates, so that a march at another
/// speed, whose modes differ, can start from it. Velocities are per radian of rotation: a harmonic keeps its engine
/// order.
struct RotorState {
  std::vector<Eigen::VectorXcd> displacement;  ///< [m in contact rows] by nodal diameter 0 .. N/2; empty: at rest
  std::vector<Eigen::VectorXcd> velocity;      ///< [m/rad in contact rows] likewise

  bool at_rest() const { return displacement.empty(); }
};

}  // namespace tiprub
