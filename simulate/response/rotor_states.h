// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/response.h"

namespace tiprub {

// States of the whole rotor in the group of a speed, or of a varied peak: `snapshot` and `cycle`, with axes beside
// them. Readers raise FileError if shapes do not fit `axes` or the number of recorded samples.

void write_snapshot(Hdf5File& file, const std::string& group, const RotorSnapshot& snapshot,
                    int samples_per_revolution, const SimulatedScene& scene);
/// `place`: of the snapshot itself.
RotorSnapshot read_snapshot(const Hdf5File& file, const std::string& place, const SimulatedScene& scene,
                            NamedAxes& axes, Eigen::Index samples);

void write_cycle(Hdf5File& file, const std::string& group, const RotorCycle& cycle, int samples_per_revolution,
                 const SimulatedScene& scene);
/// `place`: of the cycle itself.
RotorCycle read_cycle(const Hdf5File& file, const std::string& place, const SimulatedScene& scene, NamedAxes& axes,
                      Eigen::Index samples);

}  // namespace tiprub
