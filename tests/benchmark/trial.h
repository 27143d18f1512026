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
  periodic,         ///< this and the following: the class of a motion, where a map asks for it
  subharmonic,
  modulated,
  broadband,
  not_settled,
};
const char* name_of(Outcome outcome);

/// How long a trial may take: the statistics of a motion without period need many revolutions.
inline constexpr Patience patience{20, 100, 40, 1e-4};

struct Verdict {
  Outcome outcome;
  double number = 0;  ///< relative error, or e-folds a step if it grows; of a class, the motion over the clearance
  std::string note;   ///< why it is refused; what else there is to see
};

/// The fine run of the default that trials of one scene are measured by; made at the first of them.
using Reference = std::optional<SpeedResponse>;

/// Runs it through simulate_speed. What that refuses is marched all the same, by a march of its own, which refuses
/// nothing: the switch is here, and no case can reach it. Where one of the motions has no period, the error is that
/// of its root mean square or of the value that it exceeds in 1 % of the time, whichever is larger.
Verdict try_out(const Trial& trial, Reference& reference);

/// The class of the motion, and the value along the normal that it exceeds in 1 % of the time, over the clearance.
Verdict classify(const Trial& trial);

}  // namespace tiprub::simulate::testing
