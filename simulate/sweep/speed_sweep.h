// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "simulate/speed/speed_run.h"
#include "simulate/sweep/finished_speeds.h"
#include "simulate/sweep/process_group.h"

namespace tiprub {

/// One speed of a sweep and how closely it is to be looked at.
struct SpeedTask {
  double speed;  ///< [rad/s]
  Depth depth = Depth::full;
};

/// Who is told that a speed is done; called by one thread at a time. `place`: in the list of tasks.
using SpeedDone = std::function<void(const SpeedResponse&, std::size_t place)>;

/// Computes the speeds that aren't finished yet and keeps each as it comes. Speeds are independent: threads and
/// processes work over speeds, never inside one; each takes the next one that nobody has, and results don't depend on
/// their number. All processes of the group must call.
/// Raises what keep() raises, in the process where it happened; in the others RunError.
void sweep_speeds(const Scene& scene, const std::vector<SpeedTask>& missing, int threads, ProcessGroup& group,
                  FinishedSpeeds& finished, const SpeedDone& done);

/// The same for a sweep that carries its state from speed to speed, upwards or downwards: one after the other, in one
/// process. A finished speed hands on the state that was kept with it, so that an interrupted sweep goes on bit by
/// bit. Raises what keep() raises.
void carry_speeds(const Scene& scene, const std::vector<SpeedTask>& tasks, FinishedSpeeds& finished,
                  const SpeedDone& done);

}  // namespace tiprub
