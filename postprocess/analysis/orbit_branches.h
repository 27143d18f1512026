// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simulate/response/response.h"

namespace tiprub {

/// A range of speeds in which a fixed number of orbits is known.
struct OrbitRange {
  double low, high;  ///< [rad/s]
  int orbits;        ///< of all branches, at any speed within
  int attracting;    ///< of these
};

/// Ascending ranges with two orbits or more; neighbours differ in a number.
std::vector<OrbitRange> ranges_of_many_orbits(const std::vector<OrbitBranch>& branches);

}  // namespace tiprub
