// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "cases/program/command_line.h"
#include "cases/program/process_group.h"
#include "simulate/scene/scene.h"
#include "simulate/sweep/needed_terms.h"
#include "simulate/sweep/simulated_scene.h"
#include "simulate/sweep/sweep_tally.h"

namespace tiprub::simulate {

/// The outcome of a sweep. The counts are those of the leading process.
struct SweepOutcome {
  SweepTally tally;
  std::size_t speeds = 0;           ///< in the response
  std::size_t scanned = 0;          ///< only to find peaks and jumps
  std::size_t branches = 0;         ///< of orbits
  std::size_t computed = 0;         ///< speeds, full or scanned, that no former run had finished
  std::vector<double> breaking;     ///< [rad/s] speeds that break the symmetry; known to all processes
  std::vector<TermEffect> effects;  ///< of what the sweep leaves out, by its error budgets
};

/// Runs a sweep and writes arguments.output. It takes over the speeds that a former run has finished and computes the
/// others with `threads` (0: as [simulate] or the machine says) in rounds: the speeds of the case; if adaptive, a
/// scan between them and the speeds that locate each peak and jump; last, the examination of the peaks. A round
/// depends only on the results of the rounds before, so that the speeds are the same with any number of threads,
/// processes and interruptions. Then the branches are followed and the response is written. All processes of the
/// group must call. Raises RunError, and writes nothing, if a file can't be written or no speed could be computed.
SweepOutcome run_sweep(const StageArguments& arguments, const Scene& scene, const SweepSettings& settings,
                       const SceneOrigin& origin, int threads, ProcessGroup& group);

}  // namespace tiprub::simulate
