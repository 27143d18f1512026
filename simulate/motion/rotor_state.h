// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace tiprub {

/// The state of a wheel after whole revolutions, in the coordinates of the model, so that a march at another speed,
/// whose modes differ, can start from it. Velocities are per radian of rotation, so that a harmonic keeps its engine
/// order.
struct RotorState {
  std::vector<Eigen::VectorXcd> displacement;  ///< [m in contact rows] by nodal diameter 0 .. N/2; empty: at rest
  std::vector<Eigen::VectorXcd> velocity;      ///< [m/rad in contact rows] likewise

  bool at_rest() const { return displacement.empty(); }
};

/// The whole rotor at one instant, in the dofs of the reduced model. Full fields are recovered from it.
struct RotorSnapshot {
  int sample = 0;  ///< the recorded sample; the rotor angle is 2 pi sample / samples_per_revolution
  double force =
      0;  ///< [N] sum of the contact forces' magnitudes over all N sectors, mean over the sample's interval
  /// [m in contact rows] by nodal diameter, in the order of those that move: u_j = Re(sum over n of x_n e^{i n j
  /// alpha}). Contact dofs first, then generalized ones, as in model.h5.
  std::vector<Eigen::VectorXcd> displacement;
};

/// The whole rotor over the last recorded revolutions, sample by sample, from which stress over a cycle is computed.
/// It is kept for examined speeds only.
struct RotorCycle {
  int first_sample = 0;  ///< recorded sample of the first column; the last column is the last sample
  /// [m in contact rows] by nodal diameter, dofs x samples; each column as RotorSnapshot::displacement.
  std::vector<Eigen::MatrixXcd> displacement;
};

}  // namespace tiprub
