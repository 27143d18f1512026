// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed_sweep.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace tiprub {

void sweep_speeds(const Scene& scene, const std::vector<double>& speeds, int threads, FinishedSpeeds& finished,
                  const SpeedDone& done) {
  std::atomic<std::size_t> next{0};
  std::mutex one_at_a_time;  // HDF5 and OutputFile know one caller only
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < speeds.size(); i = next++) {
      try {
        const SpeedResponse response = simulate_speed(scene, speeds[i]);
        const std::lock_guard lock(one_at_a_time);
        if (failure) return;
        finished.keep(response);
        done(response);
      } catch (...) {
        const std::lock_guard lock(one_at_a_time);
        if (!failure) failure = std::current_exception();
        return;
      }
    }
  };
  std::vector<std::thread> others;
  const std::size_t wanted = std::min(static_cast<std::size_t>(std::max(threads, 1)), speeds.size());
  for (std::size_t i = 1; i < wanted; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tiprub
