// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "tests/benchmark/bench_wheel.h"

namespace tiprub::simulate::testing {

/// A speed as a case would ask for it, or as no case may.
struct Trial {
  BenchWheel wheel;
  SimulateParameters parameters;
  bool own_reference = false;  ///< the scene is no other trial's
};

enum class Outcome {
  stable,           ///< within 5 % of a fine run of the default
  inaccurate,       ///< settled or not, further off
  chatters,         ///< further off, and much of the motion is above the first families
  grows,            ///< without bound
  refused_grows,    ///< tiprub-simulate refuses it, and marched all the same it grows
  refused_bounded,  ///< refused, though the march stays bounded
  refused,          ///< there is nothing to march
};
const char* name_of(Outcome outcome);

struct Verdict {
  Outcome outcome;
  double number = 0;  ///< relative error, or e-folds a step if it grows
  std::string note;   ///< why it is refused; what else there is to see
};

/// The fine run of the default that trials of one scene are measured by; made at the first of them.
using Reference = std::optional<SpeedResponse>;

/// Runs it through simulate_speed. What that refuses is marched all the same, by a march of its own, which refuses
/// nothing: the switch is here, and no case can reach it.
Verdict try_out(const Trial& trial, Reference& reference);

}  // namespace tiprub::simulate::testing
