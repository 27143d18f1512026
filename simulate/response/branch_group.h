// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "simulate/response/named_axes.h"
#include "simulate/response/response.h"

namespace tiprub {

/// Writes `/branch/<place>` of response.h5.
void write_branch(Hdf5File& file, std::size_t place, const OrbitBranch& branch);

/// Reads all branches. Raises RunError if the arrays of a branch do not fit together or a number is out of bounds.
std::vector<OrbitBranch> read_branches(const Hdf5File& file, NamedAxes& axes);

}  // namespace tiprub
