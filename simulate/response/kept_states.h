// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/response.h"

namespace tiprub {

/// Writes the states of the whole rotor to the group of a speed: "snapshot", one instant, and "cycle", all samples of
/// the last revolutions. Both are optional.
void write_kept_states(Hdf5File& file, const std::string& group, const SpeedResponse& speed,
                       const SimulatedScene& scene);

/// Raises RunError if the states do not fit together or do not fit the number of recorded samples.
void read_kept_states(const Hdf5File& file, const std::string& group, const SimulatedScene& scene, NamedAxes& axes,
                      Eigen::Index samples, SpeedResponse& speed);

}  // namespace tiprub
