// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/speed_sweep.h"

#include <algorithm>
#include <exception>
#include <mutex>

#include "cases/program/work_together.h"

namespace tiprub {

void sweep_speeds(const Scene& scene, const std::vector<SpeedTask>& missing, int threads, ProcessGroup& group,
                  FinishedSpeeds& finished, const SpeedDone& done) {
  std::mutex one_at_a_time;  // HDF5 and OutputFile know one caller only
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = group.next(); i < missing.size(); i = group.next()) {
      try {
        const SpeedResponse response = simulate_speed(scene, missing[i].speed, missing[i].depth).response;
        const std::lock_guard lock(one_at_a_time);
        if (failure) return;
        finished.keep(response);
        done(response, i);
      } catch (...) {
        group.stop();
        const std::lock_guard lock(one_at_a_time);
        if (!failure) failure = std::current_exception();
        return;
      }
    }
  };
  work_together(static_cast<int>(std::min<std::size_t>(threads, missing.size())), work);
  group.agree(failure);
}

void carry_speeds(const Scene& scene, const std::vector<SpeedTask>& tasks, FinishedSpeeds& finished,
                  const SpeedDone& done) {
  const bool up = scene.parameters.sweep == SweepDirection::up;
  const std::size_t count = tasks.size();
  const auto place = [&](std::size_t i) { return up ? i : count - 1 - i; };
  RotorState state;
  for (std::size_t i = 0; i < count; ++i) {
    const SpeedTask& task = tasks[place(i)];
    if (finished.has(task.speed, task.depth)) {
      if (i + 1 < count && !finished.has(tasks[place(i + 1)].speed, tasks[place(i + 1)].depth))
        state = finished.read_end(task.speed);
      continue;
    }
    SpeedResult result = simulate_speed(scene, task.speed, task.depth, state);
    finished.keep(result.response, result.end);
    done(result.response, place(i));
    state = std::move(result.end);
  }
}

}  // namespace tiprub
