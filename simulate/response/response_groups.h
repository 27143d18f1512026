// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "reduce/model/hdf5_file.h"
#include "simulate/response/named_axes.h"
#include "simulate/response/response.h"

namespace tiprub {

/// The scene, which all speeds of response.h5 share. The readers raise RunError if parts do not fit together.
void write_scene(Hdf5File& file, const SimulatedScene& scene);
SimulatedScene read_scene(const Hdf5File& file, NamedAxes& axes);

void write_frequencies(Hdf5File& file, const FrequencyTable& frequencies);
/// Returns an empty table if the file has none.
FrequencyTable read_frequencies(const Hdf5File& file, int sector_count, NamedAxes& axes);

void write_scan(Hdf5File& file, const Eigen::VectorXd& speeds, const Eigen::VectorXd& amplitudes);
/// Leaves empty what the file does not have.
void read_scan(const Hdf5File& file, NamedAxes& axes, Eigen::VectorXd& speeds, Eigen::VectorXd& amplitudes);

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
