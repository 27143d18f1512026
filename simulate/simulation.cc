// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/simulation.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iomanip>
#include <memory>
#include <numbers>
#include <sstream>
#include <thread>

#include "cases/program/case_file.h"
#include "cases/program/errors.h"
#include "cases/program/output_file.h"
#include "cases/program/progress.h"
#include "reduce/model/reduced_model_file.h"
#include "simulate/march/frequency_table.h"
#include "simulate/response/response_file.h"
#include "simulate/sweep/run_key.h"
#include "simulate/sweep/speed_sweep.h"
#include "simulate/sweep/sweep_tally.h"

namespace tiprub {

namespace {

constexpr const char* program = "tiprub-simulate";
constexpr int casing_points = 721;        // of the casing's shape in the response: every half degree
constexpr double speed_tolerance = 1e-9;  // of speed_max: speeds come from rev/min

struct Inputs {
  CaseFile case_file;
  Casing casing;
  SimulateParameters parameters;
  ReducedModel model;
  std::string resolved;  ///< both tables, for -v
};

Inputs read_inputs(const StageArguments& arguments) {
  CaseFile case_file(arguments.inputs[0], arguments.settings);
  CaseTable casing_table = case_file.table("casing");
  CaseTable simulate_table = case_file.table("simulate");
  Casing casing = read_casing(casing_table);
  SimulateParameters parameters = read_simulate_parameters(simulate_table);
  ReducedModel model = read_model(arguments.inputs[1]);
  if (parameters.speeds.back() > model.speed_max * (1 + speed_tolerance)) {
    std::ostringstream text;
    text << "goes to " << rpm(parameters.speeds.back()) << " rev/min, but " << arguments.inputs[1].string()
         << " holds up to " << rpm(model.speed_max) << "; lower it, or reduce with a higher speed_max_rpm";
    simulate_table.reject(simulate_table.has("speeds_rpm") ? "speeds_rpm" : "speed_max_rpm", text.str());
  }
  const std::string resolved = "[casing]\n" + casing_table.resolved() + "[simulate]\n" + simulate_table.resolved();
  return {std::move(case_file), std::move(casing), std::move(parameters), std::move(model), resolved};
}

SimulatedScene describe(const Inputs& inputs, const SceneScope& scope) {
  SimulatedScene scene;
  scene.sector_count = inputs.model.sector_count;
  scene.independent_sectors = scope.independent_sectors;
  scene.nodal_diameters = scope.nodal_diameters;
  scene.casing_angle = Eigen::VectorXd::LinSpaced(casing_points, 0.0, 2 * std::numbers::pi);
  scene.casing_distortion =
      scene.casing_angle.unaryExpr([&](double angle) { return inputs.casing.distortion(angle); });
  scene.lobes = inputs.casing.lobes;
  scene.clearance = inputs.casing.given_clearance(inputs.model.contact);
  scene.clearance_state = inputs.casing.clearance_state == ClearanceState::cold ? "cold" : "running";
  for (const std::string& reason : scope.reasons) scene.scope += reason + "\n";
  scene.provenance = "# case\n" + inputs.case_file.source() + "\n# model\n" + inputs.model.provenance;
  return scene;
}

SweepTally assemble(const Inputs& inputs, const SimulatedScene& scene, const std::string& key, int threads,
                    FinishedSpeeds& finished, const std::filesystem::path& output) {
  SweepTally tally;
  OutputFile file(output);
  {
    ResponseWriter writer(file.scratch(), scene, key, program_version(program));
    writer.add(frequency_table(inputs.model, inputs.parameters.speeds.back(), threads));
    for (const SpeedTask& task : sweep_tasks(inputs.parameters)) {
      SpeedResponse response = finished.read(task.speed);
      if (task.check == StepCheck::none) {  // a former, other list of speeds may have asked for it
        response.audit.halving_difference.reset();
        response.audit.halving_measure.clear();
      }
      tally.add(response);
      writer.add(response);
    }
  }
  if (tally.failed < inputs.parameters.speeds.size()) file.commit();
  finished.remove();
  if (tally.failed == inputs.parameters.speeds.size())
    throw RunError("no speed could be computed; " + tally.first_failure);
  return tally;
}

int thread_count(int asked_here, const SimulateParameters& parameters, const ProcessGroup& group) {
  if (asked_here > 0) return asked_here;
  if (parameters.threads > 0) return parameters.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / group.local_size());
}

/// Computes what isn't there yet; how many speeds that were.
std::size_t compute_missing(const StageArguments& arguments, const Scene& scene, int threads, ProcessGroup& group,
                            FinishedSpeeds& finished) {
  const std::vector<SpeedTask> tasks = sweep_tasks(scene.parameters);
  std::vector<double> places;  // of the missing ones in the list; doubles, because processes share such
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (group.leads() && !finished.has(tasks[i].speed, tasks[i].check)) places.push_back(static_cast<double>(i));
  group.share(places);
  std::vector<SpeedTask> missing;
  missing.reserve(places.size());
  for (double place : places) missing.push_back(tasks[static_cast<std::size_t>(place)]);
  const bool shown = arguments.verbosity == Verbosity::normal && group.leads();
  Progress progress("speeds", missing.size(), shown ? Progress::Shown::on_a_terminal : Progress::Shown::never);
  std::size_t seen = 0;  // other processes' speeds count when this one gets a later one
  const SpeedDone done = [&](const SpeedResponse& response, std::size_t place) {
    for (const std::size_t end = std::max(seen, place) + 1; seen < std::min(end, missing.size()); ++seen)
      progress.advance();
    if (arguments.verbosity == Verbosity::verbose) say(arguments, speed_line(response));
  };
  if (scene.parameters.sweep == SweepDirection::rest) {
    sweep_speeds(scene, missing, threads, group, finished, done);
  } else {
    if (group.leads())
      carry_speeds(scene, tasks, finished, [&](const SpeedResponse& response, std::size_t) { done(response, seen); });
    group.any(false);
  }
  return missing.size();
}

void say_scope(const StageArguments& arguments, const Inputs& inputs, const SceneScope& scope) {
  const bool verbose = arguments.verbosity == Verbosity::verbose;
  if (verbose) say(arguments, inputs.resolved);
  if (verbose || arguments.action == Action::check)
    for (const std::string& reason : scope.reasons) say(arguments, reason);
}

void say_result(const StageArguments& arguments, const SimulateParameters& parameters, const SweepTally& tally,
                std::size_t computed, double seconds) {
  const std::size_t speeds = parameters.speeds.size();
  std::ostringstream line;
  line << arguments.output.string() << ": " << speeds << " speeds: " << tally.text() << "; " << speeds - computed
       << " of them from before; " << std::fixed << std::setprecision(1) << seconds << " s"
       << tally.warnings(parameters.when_symmetry_breaks);
  say(arguments, line.str());
}

/// All that a sweep is, into arguments.output; the speeds at which it breaks the symmetry, known to all processes.
std::vector<double> run_sweep(const StageArguments& arguments, const Inputs& inputs, const SceneScope& scope,
                              int threads, ProcessGroup& group) {
  const auto start = std::chrono::steady_clock::now();
  if (group.leads()) say_scope(arguments, inputs, scope);
  const std::string key = run_key(inputs.model, inputs.casing, inputs.parameters, program_version(program));
  const SimulatedScene scene = describe(inputs, scope);
  std::unique_ptr<FinishedSpeeds> finished;
  std::exception_ptr failure;
  try {
    finished = std::make_unique<FinishedSpeeds>(
        arguments.output, scene, key, program_version(program),
        group.leads() ? FinishedSpeeds::Role::keeper : FinishedSpeeds::Role::contributor);
  } catch (...) {
    failure = std::current_exception();
  }
  const bool failed_anywhere = group.any(failure != nullptr);
  if (failure) std::rethrow_exception(failure);
  if (failed_anywhere) throw RunError("another process of the sweep failed; see its message");
  threads = thread_count(threads, inputs.parameters, group);
  const std::size_t computed =
      compute_missing(arguments, {inputs.model, inputs.casing, inputs.parameters, scope}, threads, group, *finished);
  std::vector<double> breaking;
  if (group.leads()) {
    const SweepTally tally = assemble(inputs, scene, key, threads, *finished, arguments.output);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    say_result(arguments, inputs.parameters, tally, computed, spent.count());
    breaking = tally.breaking;
  }
  if (inputs.parameters.when_symmetry_breaks == BrokenSymmetry::full_run) group.share(breaking);
  return breaking;
}

/// The speeds that break the symmetry, each from rest with all nodal diameters, into a response beside the first one.
void run_whole_wheel(StageArguments arguments, Inputs inputs, const std::vector<double>& speeds, int threads,
                     ProcessGroup& group) {
  arguments.output.replace_filename(arguments.output.stem().string() + "_full" +
                                    arguments.output.extension().string());
  inputs.parameters.speeds = speeds;
  inputs.parameters.nodal_diameters = DiameterChoice::all;
  inputs.parameters.sweep = SweepDirection::rest;
  inputs.parameters.halved_step_checks = 0;
  SceneScope scope = find_scope(inputs.model.sector_count, inputs.casing.lobes, inputs.parameters);
  scope.reasons.push_back("only the speeds at which the symmetric motion of " + arguments.inputs[0].string() +
                          " repels (when_symmetry_breaks = \"full_run\")");
  run_sweep(arguments, inputs, scope, threads, group);
}

}  // namespace

void simulate(const StageArguments& arguments, int threads) {
  const Inputs inputs = read_inputs(arguments);
  const SceneScope scope = find_scope(inputs.model.sector_count, inputs.casing.lobes, inputs.parameters);
  if (arguments.action == Action::check) {
    say_scope(arguments, inputs, scope);
    return;
  }
  { const OutputFile writable(arguments.output); }  // complain before the work, not after it
  ProcessGroup group;
  const std::vector<double> breaking = run_sweep(arguments, inputs, scope, threads, group);
  if (breaking.empty() || inputs.parameters.when_symmetry_breaks == BrokenSymmetry::mark) return;
  group.restart();
  run_whole_wheel(arguments, inputs, breaking, threads, group);
}

}  // namespace tiprub
