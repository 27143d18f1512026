// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cases/program/command_line.h"
#include "simulate/scene/scene.h"
#include "simulate/sweep/finished_speeds.h"
#include "simulate/sweep/process_group.h"
#include "simulate/sweep/speed_sweep.h"

namespace tiprub {

/// Speeds to compute, and what for: "speeds", "scan", "peaks and jumps", ...
struct SpeedList {
  std::string what;
  std::vector<SpeedTask> tasks;
};

/// Computes those that aren't finished yet, with a progress bar, or a line a speed if verbose; how many these were.
/// All processes of the group must call, with the leader's list. Raises what keep() raises.
std::size_t compute_missing(const StageArguments& arguments, const Scene& scene, const SpeedList& list, int threads,
                            ProcessGroup& group, FinishedSpeeds& finished);

}  // namespace tiprub
