// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/response.h"

namespace tiprub {

/// Writes the group of one speed, "/speed/00000", ...: attributes, arrays and states of the rotor, as described in
/// simulate/format.md. A failed speed has no datasets.
void write_speed_group(Hdf5File& file, const std::string& group, const SpeedResponse& response,
                       const SimulatedScene& scene);

/// Whether every number is finite, as the reader requires.
bool is_finite(const SpeedResponse& speed);

/// Raises RunError if an attribute is missing, unknown or out of bounds, or if the arrays disagree with each
/// other, with the scene, or with the axes of the speeds that were read before.
SpeedResponse read_speed_group(const Hdf5File& file, const std::string& group, const SimulatedScene& scene,
                               NamedAxes& axes);

}  // namespace tiprub
