// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/whole_sweep.h"

#include <algorithm>
#include <memory>
#include <thread>

#include "cases/program/machine.h"
#include "simulate/speed/memory_of_speed.h"
#include "simulate/sweep/branch_runs.h"
#include "simulate/sweep/finished_speeds.h"
#include "simulate/sweep/response_assembly.h"
#include "simulate/sweep/simulated_scene.h"
#include "simulate/sweep/sweep_rounds.h"

namespace tiprub {

namespace {

int thread_count(int asked_here, const SimulateParameters& parameters, const ProcessGroup& group) {
  if (asked_here > 0) return asked_here;
  if (parameters.threads > 0) return parameters.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / group.local_size());
}

std::unique_ptr<FinishedSpeeds> open_finished(const StageArguments& arguments, const Scene& scene,
                                              const SweepSettings& settings, const SceneOrigin& origin,
                                              FinishedSpeeds::Role role) {
  const std::string generator = program_version("tiprub-simulate");
  return std::make_unique<FinishedSpeeds>(arguments.output, simulated_scene(scene, origin),
                                          run_key(scene.model, settings, scene.parameters, generator), generator,
                                          role);
}

}  // namespace

SweepOutcome run_sweep(const StageArguments& arguments, const Scene& scene, const SweepSettings& settings,
                       const SceneOrigin& origin, int threads, ProcessGroup& group) {
  threads = thread_count(threads, scene.parameters, group);
  std::unique_ptr<FinishedSpeeds> finished;
  group.together([&] {
    require_memory(scene, threads, available_memory());
    finished = open_finished(arguments, scene, settings, origin,
                             group.leads() ? FinishedSpeeds::Role::keeper : FinishedSpeeds::Role::contributor);
  });
  SweepOutcome outcome;
  const SweepSpeeds found = run_rounds(arguments, scene, threads, group, *finished);
  outcome.computed = found.computed;
  outcome.speeds = found.speeds.size();
  outcome.scanned = found.scanned;
  group.together([&] {
    if (!group.leads()) return;
    const std::vector<OrbitBranch> branches = follow_branches(
        scene, found.speeds, *finished,
        arguments.verbosity == Verbosity::normal ? Progress::Shown::on_a_terminal : Progress::Shown::never);
    outcome.branches = branches.size();
    outcome.tally = assemble_response(scene, found.speeds, branches, threads, *finished, arguments.output);
  });
  outcome.breaking = outcome.tally.breaking;
  if (scene.parameters.when_symmetry_breaks == BrokenSymmetry::full_run) group.share(outcome.breaking);
  return outcome;
}

}  // namespace tiprub
