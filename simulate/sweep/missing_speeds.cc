// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/missing_speeds.h"

#include <algorithm>
#include <vector>

#include "cases/program/progress.h"
#include "simulate/sweep/sweep_tally.h"

namespace tiprub {

namespace {

/// Those that the leader's folder doesn't hold, known to all processes.
std::vector<SpeedTask> find_missing(const std::vector<SpeedTask>& tasks, const FinishedSpeeds& finished,
                                    ProcessGroup& group) {
  std::vector<double> places;  // in the list; doubles, because processes share such
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (group.leads() && !finished.has(tasks[i].speed, tasks[i].depth)) places.push_back(static_cast<double>(i));
  group.share(places);
  std::vector<SpeedTask> missing;
  missing.reserve(places.size());
  for (double place : places) missing.push_back(tasks[static_cast<std::size_t>(place)]);
  return missing;
}

}  // namespace

std::size_t compute_missing(const StageArguments& arguments, const Scene& scene, const SpeedList& list, int threads,
                            ProcessGroup& group, FinishedSpeeds& finished) {
  const std::vector<SpeedTask> missing = find_missing(list.tasks, finished, group);
  group.restart();
  const bool shown = arguments.verbosity == Verbosity::normal && group.leads();
  Progress progress(list.what, missing.size(), shown ? Progress::Shown::on_a_terminal : Progress::Shown::never);
  std::size_t seen = 0;  // other processes' speeds count when this one gets a later one
  const SpeedDone done = [&](const SpeedResponse& response, std::size_t place) {
    for (const std::size_t end = std::max(seen, place) + 1; seen < std::min(end, missing.size()); ++seen)
      progress.advance();
    if (arguments.verbosity == Verbosity::verbose) say(arguments, speed_line(response));
  };
  if (scene.parameters.sweep == SweepDirection::rest) {
    sweep_speeds(scene, missing, threads, group, finished, done);
  } else {
    group.together([&] {
      if (group.leads())
        carry_speeds(scene, list.tasks, finished,
                     [&](const SpeedResponse& response, std::size_t) { done(response, seen); });
    });
  }
  return missing.size();
}

}  // namespace tiprub
