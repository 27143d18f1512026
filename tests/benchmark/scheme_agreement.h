// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simulate/response/response.h"
#include "tests/benchmark/bench_wheel.h"

namespace tiprub::simulate::testing {

/// What two schemes say of one speed: the default and central differences, each with the step that it needs.
struct SchemePair {
  double speed = 0;                      ///< [rad/s]
  SpeedResponse trigonometric, central;  ///< without their samples
  double amplitude_difference = 0;       ///< [1] of the largest amplitude of a node, averaged over revolutions
  double pattern_overlap = 0;            ///< [1] common part of the two contact maps, each of sum 1
  bool agree() const;
};
constexpr double same_amplitude = 0.02;  // relative
constexpr double same_pattern = 0.9;     // contact by node and 6 degrees of the casing

/// `count` speeds evenly from `slowest` to `fastest` [rad/s].
std::vector<SchemePair> compare_schemes(const BenchWheel& wheel, double slowest, double fastest, int count);

/// "periodic", "subharmonic 1/2", "broadband", ..., or "failed".
std::string class_of(const SpeedResponse& at);

}  // namespace tiprub::simulate::testing
