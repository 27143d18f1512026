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

/// By what an orbit repels, or would first: where its largest multiplier leaves the unit circle.
enum class Instability {
  fold,   ///< at 1: it meets another orbit
  flip,   ///< at -1: one of twice the period branches off
  torus,  ///< elsewhere: a second frequency comes in
};
/// `angle` [rad] 0 .. pi, of the largest multiplier of a map.
Instability instability(double angle);
const char* name_of(Instability kind);

/// Where an orbit's largest multiplier passes 1.
struct StabilityChange {
  double speed;  ///< [rad/s] between two orbits, by the logarithms of their multipliers
  Instability kind;
};
/// Ascending in speed.
std::vector<StabilityChange> stability_changes(const std::vector<OrbitBranch>& branches);

/// Ascending ranges with two orbits or more; neighbours differ in a number.
std::vector<OrbitRange> ranges_of_many_orbits(const std::vector<OrbitBranch>& branches);

}  // namespace tiprub
