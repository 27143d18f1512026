// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub {

/// The part of a contact node's displacement that is looked at.
enum class Component {
  normal,      ///< along the normal from the blade to the casing: what closes the gap
  radial,      ///< r
  tangential,  ///< theta, with the rotation
  axial,       ///< z
};

/// A displacement component of one contact node in all N sectors [m]; samples x N. Sector j moves as sector
/// j mod (N/g), the independent ones in the file.
Eigen::MatrixXd tip_motion(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                           int node, Component component);

/// The contact force [N] of one contact node in all N sectors; samples x N.
Eigen::MatrixXd tip_force(const SpeedResponse& response, const SimulatedScene& scene, int node);

/// Half of the peak-to-peak motion, the largest over the sectors; unit of the motion.
double vibration_amplitude(const Eigen::MatrixXd& motion);

}  // namespace tiprub
