// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/response.h"

namespace tiprub {

/// The whole rotor in a speed's group of response.h5: "snapshot", one instant, and "cycle", all samples of the last
/// revolutions. Both are optional.
void write_kept_states(Hdf5File& file, const std::string& group, const SpeedResponse& speed,
                       const SimulatedScene& scene);

/// Raises RunError if they don't fit together or to the `samples` that were recorded.
void read_kept_states(const Hdf5File& file, const std::string& group, const SimulatedScene& scene, NamedAxes& axes,
                      Eigen::Index samples, SpeedResponse& speed);

}  // namespace tiprub
