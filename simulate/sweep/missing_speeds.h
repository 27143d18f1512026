// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "cases/program/command_line.h"
#include "simulate/scene/scene.h"
#include "simulate/sweep/finished_speeds.h"
#include "simulate/sweep/process_group.h"

namespace tiprub {

/// Computes the speeds of a sweep that aren't finished yet, with a progress bar, or a line a speed if verbose; how
/// many these were. All processes of the group must call. Raises what keep() raises.
std::size_t compute_missing(const StageArguments& arguments, const Scene& scene, int threads, ProcessGroup& group,
                            FinishedSpeeds& finished);

}  // namespace tiprub
