// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reduce/model/hdf5_file.h"

namespace tiprub {

/// Writes a dataset and makes it a netCDF coordinate axis.
void write_axis(Hdf5File& file, const std::string& name, const Eigen::VectorXd& values, const std::string& unit,
                const std::string& long_name);

/// The same for an axis that counts 0, 1, ...
void write_counting_axis(Hdf5File& file, const std::string& name, Eigen::Index count, const std::string& long_name);

}  // namespace tiprub
