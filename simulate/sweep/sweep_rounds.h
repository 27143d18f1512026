// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "cases/program/command_line.h"
#include "simulate/scene/scene.h"
#include "simulate/sweep/finished_speeds.h"
#include "simulate/sweep/process_group.h"

namespace tiprub {

/// The speeds that a sweep came to.
struct SweepSpeeds {
  std::vector<double> speeds;  ///< [rad/s] ascending
  std::size_t computed = 0;    ///< that weren't there from before, scanned ones included
  std::size_t scanned = 0;     ///< only for where to look; not among the speeds
};

/// Round after round: the speeds of the case; if adaptive, a scan between them, then what it takes to locate each
/// peak and jump (speeds_to_refine()); last, the examination of the peaks. What a round does hangs on the results of
/// those before alone: with whatever threads, processes and interruptions, the same speeds. All processes of the
/// group must call. Raises what keep() raises.
SweepSpeeds run_rounds(const StageArguments& arguments, const Scene& scene, int threads, ProcessGroup& group,
                       FinishedSpeeds& finished);

}  // namespace tiprub
