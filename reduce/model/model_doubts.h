// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/reduced_model.h"

namespace tiprub {

/// What makes all results of a model doubtful, for the first line of every summary: "warning: ...; ", or empty. These
/// are shift_doubts(), a shape under spin that is less in balance than was asked for, and a polynomial K(Omega) that
/// misses frequencies by more than 0.1 %.
std::string doubts(const ReducedModel& model);

/// Says so if spin at a speed [rad/s] moves the tip by more than 2 % of its radius: no metal strains so much, a value
/// is in another unit. Places and shifts [m] are r, theta, z of some nodes; n x 3.
std::string shift_doubts(const Eigen::MatrixX3d& position, const Eigen::MatrixX3d& shift, double speed);

}  // namespace tiprub
