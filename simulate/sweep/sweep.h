// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "cases/program/command_line.h"
#include "simulate/scene/scene.h"
#include "simulate/sweep/process_group.h"
#include "simulate/sweep/run_key.h"
#include "simulate/sweep/simulated_scene.h"
#include "simulate/sweep/sweep_tally.h"

namespace tiprub {

/// What a sweep came to.
struct SweepOutcome {
  SweepTally tally;              ///< the leader's
  std::size_t speeds = 0;        ///< the leader's: of the response
  std::size_t scanned = 0;       ///< the leader's: only for where to look
  std::size_t branches = 0;      ///< the leader's: of orbits, that were followed
  std::size_t computed = 0;      ///< of both, that weren't there from before
  std::vector<double> breaking;  ///< [rad/s] speeds that break the symmetry; all processes know them
};

/// All that a sweep is, into arguments.output. It takes over what a former run finished and computes the rest with
/// `threads` (0: as [simulate] or the machine says), round after round: the speeds of the case; if adaptive, a scan
/// between them, then what it takes to locate each peak and jump (speeds_to_refine()); last, the examination of the
/// peaks. What a round does hangs on the results of those before alone: with whatever threads, processes and
/// interruptions, the same speeds. Then it follows the branches, and writes the response. All processes of the group
/// must call. Raises RunError, and writes nothing, if a file can't be written or no speed could be computed.
SweepOutcome run_sweep(const StageArguments& arguments, const Scene& scene, const SweepSettings& settings,
                       const SceneOrigin& origin, int threads, ProcessGroup& group);

}  // namespace tiprub
