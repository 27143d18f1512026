// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace tiprub
