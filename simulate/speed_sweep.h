// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "simulate/finished_speeds.h"
#include "simulate/speed_run.h"

namespace tiprub {

/// Who is told that a speed is done; called by one thread at a time.
using SpeedDone = std::function<void(const SpeedResponse&)>;

/// Computes the speeds that aren't finished yet and keeps each as it comes. Speeds are independent: threads work
/// over speeds, never inside one, and results don't depend on their number. (Processes would share the speeds out in
/// the same way: each takes the next one that nobody has.)
/// Raises what keep() raises.
void sweep_speeds(const Scene& scene, const std::vector<double>& speeds, int threads, FinishedSpeeds& finished,
                  const SpeedDone& done);

}  // namespace tiprub
