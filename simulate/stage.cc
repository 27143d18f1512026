// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stage.h"

#include <chrono>
#include <iomanip>
#include <sstream>

#include "cases/program/units.h"
#include "reduce/model/model_doubts.h"
#include "reduce/model/reduced_model_file.h"
#include "simulate/scene/friction_limit.h"
#include "simulate/sweep/sweep.h"

namespace tiprub::simulate {

namespace {

constexpr double speed_tolerance = 1e-9;  // of speed_max, for rounding in the conversion from rev/min

struct Inputs {
  Casing casing;
  SimulateParameters parameters;
  ReducedModel model;
  SweepSettings settings;
  std::string resolved;  ///< both tables with defaults, for -v
  SceneOrigin origin;

  SceneScope scope() const { return find_scope(model.sector_count, casing.lobes, parameters); }
};

void require_speed_of_model(const CaseTable& table, const char* key, double speed, const ReducedModel& model,
                            const std::filesystem::path& file) {
  if (speed <= model.speed_max * (1 + speed_tolerance)) return;
  std::ostringstream text;
  text << "goes to " << speed * rpm_per_rad_s << " rev/min, but " << file.string() << " holds up to "
       << model.speed_max * rpm_per_rad_s << "; lower it, or reduce with a higher speed_max_rpm";
  table.reject(key, text.str());
}

Inputs read_inputs(const StageArguments& arguments) {
  CaseFile case_file(arguments.inputs[0], arguments.settings);
  CaseTable casing_table = case_file.table("casing");
  CaseTable simulate_table = case_file.table("simulate");
  Casing casing = read_casing(casing_table);
  SimulateParameters parameters = read_simulate_parameters(simulate_table);
  ReducedModel model = read_model(arguments.inputs[1]);
  require_lengths_in_metres(casing_table, casing, model.contact);
  require_ramp_within(casing_table, casing, parameters);
  require_blades_of_wheel(casing_table, casing, parameters, model.sector_count);
  require_speed_of_model(simulate_table, simulate_table.has("speeds_rpm") ? "speeds_rpm" : "speed_max_rpm",
                         parameters.speeds.back(), model, arguments.inputs[1]);
  require_speed_of_model(casing_table, "clearance_speed_rpm", casing.clearance_speed, model, arguments.inputs[1]);
  require_units_of_model(simulate_table, parameters, model);
  require_gap_of_model(simulate_table, parameters, model);
  fit_to_model(parameters, model);
  require_friction_that_slides(casing_table, casing, parameters, model);
  const std::string resolved = "[casing]\n" + casing_table.resolved() + "[simulate]\n" + simulate_table.resolved();
  const std::string provenance = "# case\n" + case_file.source() + "\n# model\n" + model.provenance;
  return {std::move(casing), std::move(parameters),
          std::move(model),  {casing_table.settings(), simulate_table.settings()},
          resolved,          {provenance, casing_table.written()}};
}

/// Reports the scope and, if verbose, all parameters before it.
void report_scope(const StageArguments& arguments, const Inputs& inputs, const SceneScope& scope) {
  const bool verbose = arguments.verbosity == Verbosity::verbose;
  if (verbose) say(arguments, inputs.resolved);
  if (!verbose && arguments.action != Action::check) return;
  for (const std::string& reason : scope.reasons) say(arguments, reason);
  say(arguments, "friction: " + friction_limit(inputs.model).text());
}

void report_outcome(const StageArguments& arguments, const Inputs& inputs, const SweepOutcome& outcome,
                    std::chrono::duration<double> spent) {
  std::ostringstream line;
  line << arguments.output.string() << ": " << doubts(inputs.model) << outcome.speeds
       << " speeds: " << outcome.tally.text() << "; ";
  if (outcome.scanned > 0) line << outcome.scanned << " more scanned; ";
  if (outcome.branches > 0) line << outcome.branches << " branches of orbits; ";
  line << outcome.computed << " computed now; " << std::fixed << std::setprecision(1) << spent.count() << " s"
       << outcome.tally.warnings(inputs.parameters);
  say(arguments, line.str());
}

/// Runs and reports a sweep. Returns the speeds that break the symmetry.
std::vector<double> run(const StageArguments& arguments, const Inputs& inputs, const SceneScope& scope, int threads,
                        ProcessGroup& group) {
  const auto start = std::chrono::steady_clock::now();
  if (group.leads()) report_scope(arguments, inputs, scope);
  const SweepOutcome outcome = run_sweep(arguments, {inputs.model, inputs.casing, inputs.parameters, scope},
                                         inputs.settings, inputs.origin, threads, group);
  if (group.leads()) report_outcome(arguments, inputs, outcome, std::chrono::steady_clock::now() - start);
  return outcome.breaking;
}

/// Runs the speeds that break the symmetry, each from rest with all nodal diameters, into a response beside the
/// first. Settings that decide results are set as by --set, so that they enter the key of the run.
void run_whole_wheel(StageArguments arguments, const std::vector<double>& speeds, int threads, ProcessGroup& group) {
  arguments.output.replace_filename(arguments.output.stem().string() + "_full" +
                                    arguments.output.extension().string());
  for (const char* setting : {"simulate.nodal_diameters=\"all\"", "simulate.sweep=\"rest\""})
    arguments.settings.emplace_back(setting);
  Inputs inputs = read_inputs(arguments);
  inputs.parameters.speeds = speeds;
  inputs.parameters.speed_choice = SpeedChoice::given;
  inputs.parameters.examination = Examination::none;
  SceneScope scope = inputs.scope();
  scope.reasons.push_back("only the speeds at which the symmetric motion of " + arguments.inputs[0].string() +
                          " is unstable (when_symmetry_breaks = \"full_run\")");
  run(arguments, inputs, scope, threads, group);
}

}  // namespace

std::string simulate_tables(const CaseFile& file) {
  return file.resolved("casing", read_casing) + file.resolved("simulate", read_simulate_parameters);
}

void run_simulate(const StageArguments& arguments, int threads) {
  const Inputs inputs = read_inputs(arguments);
  const SceneScope scope = inputs.scope();
  if (arguments.action == Action::check) {
    report_scope(arguments, inputs, scope);
    return;
  }
  ProcessGroup group;
  if (group.leads()) say_blas(arguments);
  const std::vector<double> breaking = run(arguments, inputs, scope, threads, group);
  if (breaking.empty() || inputs.parameters.when_symmetry_breaks == BrokenSymmetry::mark) return;
  group.restart();
  run_whole_wheel(arguments, breaking, threads, group);
}

}  // namespace tiprub::simulate
