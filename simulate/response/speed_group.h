// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/response.h"

namespace tiprub {

/// One speed's group of response.h5, "/speed/00000", ...: attributes, arrays and states of the rotor, as
/// simulate/format.md lists them. A speed that failed has no datasets.
void write_speed_group(Hdf5File& file, const std::string& group, const SpeedResponse& response,
                       const SimulatedScene& scene);

/// Whether every number of it is finite; a reader refuses others.
bool is_finite(const SpeedResponse& speed);

/// Raises RunError if an attribute is missing, unknown or out of its bounds, or the arrays don't fit together, to the
/// scene, and to the speeds that were read with the same axes.
SpeedResponse read_speed_group(const Hdf5File& file, const std::string& group, const SimulatedScene& scene,
                               NamedAxes& axes);

}  // namespace tiprub
