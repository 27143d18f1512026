// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "simulate/response/response.h"
#include "simulate/scene/simulate_parameters.h"

namespace tiprub::simulate {

/// The outcome of a speed in one line.
std::string speed_line(const SpeedResponse& response);

/// How near the tips come to the casing if they don't vibrate, at the speed at which that is nearest.
struct ClosestApproach {
  double gap = std::numeric_limits<double>::infinity();  ///< [m]
  double speed = 0;                                      ///< [rad/s]
  int node = 0;                                          ///< contact node

  bool operator<(const ClosestApproach& other) const { return gap < other.gap; }
};

/// The counts of a sweep, for its summary.
struct SweepTally {
  std::map<MotionClass, std::size_t> motions;  ///< number of speeds of each class
  std::size_t failed = 0;
  std::size_t touching = 0;         ///< speeds with contact in the recorded motion
  std::size_t pulling = 0;          ///< speeds with tensile contact forces
  std::size_t penetrating = 0;      ///< speeds with steps that leave a node in the casing
  std::vector<double> breaking;     ///< [rad/s] speeds at which a nodal diameter that was left out grows
  std::size_t apart_from_rest = 0;  ///< speeds whose motion differs from that of a start from rest
  int marched = 0;                  ///< speeds at which a stable orbit was sought but not found
  std::size_t unreached = 0;        ///< speeds whose step does not meet step_tolerance
  double farthest = 0;              ///< [1] the largest estimated error of a step over step_tolerance
  std::size_t halved = 0;           ///< speeds also computed with half the step
  double largest_halving = 0;       ///< [1] the largest change by halving the step
  double tension_share = 0;         ///< [1] the largest share of tensile contact force
  std::size_t judged = 0;           ///< speeds with a Floquet multiplier of a motion in contact
  double rub_power = 0;             ///< [W] the largest mean power of friction at a speed
  Eigen::VectorXd crest;            ///< [m] the largest distortion inward by contact node; empty if not known
  ClosestApproach closest;          ///< if `crest` is known
  std::string first_failure;
  bool cut_short = false;  ///< whether speed_count_max ended the search for peaks

  void add(const SpeedResponse& response);
  std::string text() const;
  /// If no tip touches the casing at any speed, a line that says so and how near they come, preceded by a line break.
  std::string untouched(const ContactLine& contact) const;
  /// One line for each finding that the user should look at, each preceded by a line break.
  std::string warnings(const SimulateParameters& parameters = {}) const;
};

}  // namespace tiprub::simulate
