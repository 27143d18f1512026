// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "simulate/response/response.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub {

/// What happened at a speed, for people: one line.
std::string speed_line(const SpeedResponse& response);

/// What a sweep came to.
struct SweepTally {
  std::map<MotionClass, std::size_t> motions;  ///< how many speeds of each class
  std::size_t failed = 0;
  std::size_t pulling = 0;          ///< speeds with a casing that pulls
  std::size_t penetrating = 0;      ///< speeds with steps that leave a node in the casing
  std::vector<double> breaking;     ///< [rad/s] speeds at which a nodal diameter left out grows
  std::size_t apart_from_rest = 0;  ///< speeds whose motion is another one from rest
  int marched = 0;                  ///< speeds at which no stable orbit was found, though one was looked for
  std::size_t halved = 0;           ///< speeds computed with half the step as well
  double largest_halving = 0;       ///< [1] the largest difference there
  double tension_share = 0;         ///< [1] the largest share of tensile contact force
  std::string first_failure;

  void add(const SpeedResponse& response);
  std::string text() const;
  /// A line for each thing that asks for a decision, each with a line break before it.
  std::string warnings(BrokenSymmetry broken = BrokenSymmetry::mark) const;
};

}  // namespace tiprub
