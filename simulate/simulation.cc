// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <thread>

#include "cases/case_file.h"
#include "cases/errors.h"
#include "cases/output_file.h"
#include "cases/progress.h"
#include "reduce/reduced_model_file.h"
#include "simulate/response_file.h"
#include "simulate/run_key.h"
#include "simulate/speed_sweep.h"

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

double rpm(double speed) {
  return speed * 60 / (2 * std::numbers::pi);
}

Inputs read_inputs(const StageArguments& arguments) {
  CaseFile case_file(arguments.inputs[0]);
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

std::string speed_line(const SpeedResponse& at) {
  std::ostringstream text;
  text << rpm(at.speed) << " rev/min: ";
  if (!at.failure.empty()) {
    text << "failed: " << at.failure;
    return text.str();
  }
  text << (at.motion == MotionClass::periodic      ? "periodic"
           : at.motion == MotionClass::subharmonic ? "subharmonic of order " + std::to_string(at.period_revolutions)
                                                   : "irregular");
  text << " after " << at.revolutions << " revolutions of " << at.steps_per_revolution << " steps, change "
       << at.change << " (x " << at.change_rate << " a revolution), " << at.contact_steps
       << " steps in contact, energy closes to " << at.energy.closing_error;
  if (at.tension_steps > 0) text << ", " << at.tension_steps << " steps pull";
  if (at.solver_fallbacks > 0) text << ", " << at.solver_fallbacks << " solver fallbacks";
  return text.str();
}

/// What a sweep came to, for one line.
struct Tally {
  std::size_t periodic = 0, subharmonic = 0, irregular = 0, failed = 0, pulling = 0;
  std::string first_failure;

  void add(const SpeedResponse& at) {
    if (!at.failure.empty()) {
      if (failed++ == 0) first_failure = speed_line(at);
      return;
    }
    if (at.tension_steps > 0) ++pulling;
    ++(at.motion == MotionClass::periodic      ? periodic
       : at.motion == MotionClass::subharmonic ? subharmonic
                                               : irregular);
  }
  std::string text() const {
    std::ostringstream out;
    out << periodic << " periodic, " << subharmonic << " subharmonic, " << irregular << " irregular, " << failed
        << " failed";
    if (pulling > 0) out << ", " << pulling << " with a casing that pulls";
    return out.str();
  }
};

Tally assemble(const Inputs& inputs, const SimulatedScene& scene, const std::string& key, FinishedSpeeds& finished,
               const std::filesystem::path& output) {
  Tally tally;
  OutputFile file(output);
  {
    ResponseWriter writer(file.scratch(), scene, key, program_version(program));
    for (double speed : inputs.parameters.speeds) {
      const SpeedResponse response = finished.read(speed);
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

int thread_count(int asked_here, const SimulateParameters& parameters) {
  if (asked_here > 0) return asked_here;
  if (parameters.threads > 0) return parameters.threads;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Computes what isn't there yet; how many speeds that were.
std::size_t compute_missing(const StageArguments& arguments, const Scene& scene, int threads,
                            FinishedSpeeds& finished) {
  std::vector<double> missing;
  for (double speed : scene.parameters.speeds)
    if (!finished.has(speed)) missing.push_back(speed);
  Progress progress(
      "speeds", missing.size(),
      arguments.verbosity == Verbosity::normal ? Progress::Shown::on_a_terminal : Progress::Shown::never);
  sweep_speeds(scene, missing, threads, finished, [&](const SpeedResponse& response) {
    progress.advance();
    if (arguments.verbosity == Verbosity::verbose) say(arguments, speed_line(response));
  });
  return missing.size();
}

void say_scope(const StageArguments& arguments, const Inputs& inputs, const SceneScope& scope) {
  const bool verbose = arguments.verbosity == Verbosity::verbose;
  if (verbose) say(arguments, inputs.resolved);
  if (verbose || arguments.action == Action::check)
    for (const std::string& reason : scope.reasons) say(arguments, reason);
}

void say_result(const StageArguments& arguments, const Tally& tally, std::size_t computed, std::size_t speeds,
                double seconds) {
  std::ostringstream line;
  line << arguments.output.string() << ": " << speeds << " speeds: " << tally.text() << "; " << speeds - computed
       << " of them from before; " << std::fixed << std::setprecision(1) << seconds << " s";
  if (tally.failed > 0) line << "\nfirst failure: " << tally.first_failure;
  say(arguments, line.str());
}

}  // namespace

void simulate(const StageArguments& arguments, int threads) {
  const auto start = std::chrono::steady_clock::now();
  const Inputs inputs = read_inputs(arguments);
  const SceneScope scope = find_scope(inputs.model.sector_count, inputs.casing.lobes, inputs.parameters);
  say_scope(arguments, inputs, scope);
  if (arguments.action == Action::check) return;
  { const OutputFile writable(arguments.output); }  // complain before the work, not after it
  const std::string key = run_key(inputs.model, inputs.casing, inputs.parameters, program_version(program));
  const SimulatedScene scene = describe(inputs, scope);
  FinishedSpeeds finished(arguments.output, scene, key, program_version(program));
  const std::size_t computed = compute_missing(arguments, {inputs.model, inputs.casing, inputs.parameters, scope},
                                               thread_count(threads, inputs.parameters), finished);
  const Tally tally = assemble(inputs, scene, key, finished, arguments.output);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  say_result(arguments, tally, computed, inputs.parameters.speeds.size(), spent.count());
}

}  // namespace tiprub
