// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stage.h"

#include <cblas.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>

#include "cases/program/case_file.h"
#include "cases/program/errors.h"
#include "cases/program/output_file.h"
#include "cases/program/text.h"
#include "cases/program/units.h"
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
  std::optional<ReducedModel> other_model;  ///< of the same wheel, for error budgets
  std::vector<Variation> open;              ///< terms of contact that physics = "as_needed" decides on
  SweepSettings settings;
  std::string resolved;     ///< both tables with defaults, for -v
  std::string differences;  ///< of the case from that of the model
  SceneOrigin origin;

  const ReducedModel* other() const { return other_model ? &*other_model : nullptr; }
  SceneScope scope() const { return find_scope(model.sector_count, casing.lobes, parameters); }
};

void require_speed_of_model(const CaseTable& table, const char* key, double speed, const ReducedModel& model,
                            const std::filesystem::path& file) {
  if (speed <= model.speed_max * (1 + speed_tolerance)) return;
  table.reject(key, text_of("goes to ", speed * rpm_per_rad_s, " rev/min, but ", file.string(), " holds up to ",
                            model.speed_max * rpm_per_rad_s, "; lower it, or reduce with a higher speed_max_rpm"));
}

/// The model that error budgets compare with, if the case names one.
std::optional<ReducedModel> read_other_model(const CaseTable& table, const std::filesystem::path& case_file,
                                             const SimulateParameters& parameters, const ReducedModel& model) {
  const char* const key = "budget_model";
  if (parameters.budget_model.empty()) return std::nullopt;
  const std::filesystem::path file = case_file.parent_path() / parameters.budget_model;
  ReducedModel other = read_model(file);
  if (other.sector_count != model.sector_count)
    table.reject(key, "is of " + std::to_string(other.sector_count) + " sectors, and the model of " +
                          std::to_string(model.sector_count) + "; name another model of the same wheel");
  if (parameters.speeds.back() > other.speed_max * (1 + speed_tolerance)) {
    table.reject(key, text_of("holds up to ", other.speed_max * rpm_per_rad_s, " rev/min, and the speeds go to ",
                              parameters.speeds.back() * rpm_per_rad_s, "; reduce it with a higher speed_max_rpm"));
  }
  return other;
}

/// The terms that the case leaves open, if it wants them as needed.
std::vector<Variation> open_terms(const CaseTable& casing, const CaseTable& simulate,
                                  const SimulateParameters& parameters, const ReducedModel& model) {
  std::vector<Variation> open;
  if (parameters.physics == PhysicsChoice::as_given) return open;
  if (parameters.gap == GapOrder::automatic && model.contact.second_order) open.push_back(Variation::gap);
  if (!casing.has("friction_coefficient") && parameters.budget_friction > 0) open.push_back(Variation::friction);
  if (open.empty())
    simulate.reject("physics",
                    "= \"as_needed\" finds nothing to decide: the case gives friction_coefficient, and gap or a "
                    "model without the second order of the gap; leave one of these keys out, or physics");
  return open;
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
  std::optional<ReducedModel> other = read_other_model(simulate_table, arguments.inputs[0], parameters, model);
  std::vector<Variation> open = open_terms(casing_table, simulate_table, parameters, model);
  fit_to_model(parameters, model);
  require_modes_of_wheel(simulate_table, parameters.damping, model);
  require_friction_that_slides(casing_table, casing, parameters, model);
  const std::string resolved = "[casing]\n" + casing_table.resolved() + "[simulate]\n" + simulate_table.resolved();
  const std::string differences =
      made_otherwise(arguments.inputs[1].filename().string(), model.provenance, case_file.source(),
                     {"mesh.", "reduce."}, "the results are those of the model")
          .lines;
  const std::string provenance = "# case\n" + case_file.source() + "\n# model\n" + model.provenance;
  return {std::move(casing), std::move(parameters), std::move(model),
          std::move(other),  std::move(open),       {casing_table.settings(), simulate_table.settings()},
          resolved,          differences,           {provenance, casing_table.written()}};
}

/// "casing: crests of up to 0.25 mm and clearances of 0.2 .. 0.236 mm at these speeds: a tip at rest overlaps the
/// crests by up to 0.05 mm"
std::string interference_text(const Inputs& inputs) {
  const std::vector<double>& speeds = inputs.parameters.speeds;
  const Eigen::VectorXd slow = inputs.casing.running_clearance(inputs.model.contact, speeds.front()),
                        fast = inputs.casing.running_clearance(inputs.model.contact, speeds.back());
  const Eigen::VectorXd least = slow.cwiseMin(fast), crests = inputs.casing.crests(inputs.model.contact);
  const double overlap = (crests - least).maxCoeff();
  std::ostringstream text;
  text << std::setprecision(3) << "casing: crests of up to " << mm_per_m * crests.maxCoeff()
       << " mm and clearances of " << mm_per_m * least.minCoeff() << " .. "
       << mm_per_m * std::max(slow.maxCoeff(), fast.maxCoeff()) << " mm at these speeds: ";
  if (overlap > 0)
    text << "a tip that does not vibrate overlaps the crests by up to " << mm_per_m * overlap << " mm";
  else
    text << "no tip touches unless it vibrates by more than " << mm_per_m * std::abs(overlap) << " mm";
  return text.str();
}

/// Reports the scope and, if verbose, all parameters before it.
void report_scope(const StageArguments& arguments, const Inputs& inputs, const SceneScope& scope) {
  const bool verbose = arguments.verbosity == Verbosity::verbose;
  if (verbose) say(arguments, inputs.resolved);
  if (!verbose && arguments.action != Action::check) return;
  for (const std::string& reason : scope.reasons) say(arguments, reason);
  if (!inputs.differences.empty()) say(arguments, inputs.differences.substr(1));
  say(arguments, interference_text(inputs));
  say(arguments, (inputs.casing.has_friction() ? "friction: " : "friction: none in this case; ") +
                     friction_limit(inputs.model).text());
  if (inputs.parameters.examination == Examination::none)
    say(arguments, "error budgets: none, because examine = \"none\"");
  else if (inputs.parameters.sweep != SweepDirection::rest)
    say(arguments, "error budgets: none, because a sweep up or down examines no speeds");
  for (const Variation term : inputs.open)
    say(arguments,
        std::string(name_of(term)) + ": swept without, then with it if it is needed (physics = \"as_needed\")");
}

void report_outcome(const StageArguments& arguments, const Inputs& inputs, const SweepOutcome& outcome,
                    std::chrono::duration<double> spent) {
  std::ostringstream line;
  line << arguments.output.string() << ": " << doubts(inputs.model) << outcome.speeds
       << " speeds: " << outcome.tally.text() << "; ";
  if (outcome.scanned > 0) line << outcome.scanned << " more scanned; ";
  if (outcome.branches > 0) line << outcome.branches << " branches of orbits; ";
  line << outcome.computed << " computed now; " << std::fixed << std::setprecision(1) << spent.count() << " s"
       << outcome.tally.untouched(inputs.model.contact) << outcome.tally.warnings(inputs.parameters)
       << inputs.differences;
  say(arguments, line.str());
}

/// Runs and reports a sweep.
SweepOutcome run(const StageArguments& arguments, const Inputs& inputs, const SceneScope& scope, int threads,
                 ProcessGroup& group) {
  const auto start = std::chrono::steady_clock::now();
  if (group.leads()) report_scope(arguments, inputs, scope);
  const SweepOutcome outcome =
      run_sweep(arguments, {inputs.model, inputs.casing, inputs.parameters, scope, inputs.other()}, inputs.settings,
                inputs.origin, threads, group);
  if (group.leads()) report_outcome(arguments, inputs, outcome, std::chrono::steady_clock::now() - start);
  return outcome;
}

std::string exact_text(double value) {
  return text_of(std::setprecision(std::numeric_limits<double>::max_digits10), value);
}

void copy_whole(const std::filesystem::path& from, const std::filesystem::path& to) {
  OutputFile file(to);
  std::error_code error;
  std::filesystem::copy_file(from, file.scratch(), std::filesystem::copy_options::overwrite_existing, error);
  if (error) throw RunError(to.string() + ": can't be copied from " + from.string() + ": " + error.message());
  file.commit();
}

/// "response_full.h5" beside "response.h5".
std::filesystem::path beside(const std::filesystem::path& output, const std::string& suffix) {
  std::filesystem::path path = output;
  return path.replace_filename(output.stem().string() + suffix + output.extension().string());
}

/// The case with its open terms on or off.
StageArguments with_terms(StageArguments arguments, const Inputs& asked, const std::set<Variation>& on) {
  arguments.settings.emplace_back("simulate.physics=\"as_given\"");
  if (asked.parameters.budget == BudgetChoice::critical_speeds)  // the default if terms are to be decided on
    arguments.settings.emplace_back("simulate.budget=\"critical_speeds\"");
  for (const Variation term : asked.open) {
    if (term == Variation::gap)
      arguments.settings.emplace_back(on.contains(term) ? "simulate.gap=\"second_order\""
                                                        : "simulate.gap=\"linear\"");
    else if (on.contains(term))
      arguments.settings.emplace_back("casing.friction_coefficient=" + exact_text(asked.parameters.budget_friction));
  }
  return arguments;
}

/// The inputs with other settings, which count as those of the case: a report compares [casing] with the case's own.
Inputs read_as(const Inputs& asked, const StageArguments& arguments) {
  Inputs inputs = read_inputs(arguments);
  inputs.origin.casing = asked.origin.casing;
  return inputs;
}

/// The decisions on open terms.
struct Decisions {
  std::set<Variation> on;
  std::vector<std::string> reasons;  ///< of the leader only
};

/// Decides by a sweep on the terms that it left out. Returns whether any is needed.
bool decide_more(const SweepOutcome& outcome, const Inputs& asked, ProcessGroup& group, Decisions& decisions) {
  std::vector<double> needed;  // as doubles, which processes can share
  std::vector<std::string> off;
  for (const Variation term : asked.open) {
    if (decisions.on.contains(term)) continue;
    const Decision decision = decide(term, outcome.effects, asked.parameters.accuracy);
    if (decision.is_needed) needed.push_back(static_cast<double>(term));
    (decision.is_needed ? decisions.reasons : off).push_back("physics as needed: " + decision.reason);
  }
  group.share(needed);
  for (const double term : needed) decisions.on.insert(static_cast<Variation>(static_cast<int>(term)));
  if (needed.empty()) decisions.reasons.insert(decisions.reasons.end(), off.begin(), off.end());
  return !needed.empty();
}

/// Sweeps without the open terms, and again with those that were needed, until no other one is. Each of these sweeps
/// stays in a file of its own, from which an interrupted run takes its speeds over; so does `output` from the last
/// one, if that has all that is needed.
Decisions decide_terms(const StageArguments& arguments, const Inputs& asked, int threads, ProcessGroup& group) {
  Decisions decisions;
  while (decisions.on.size() < asked.open.size()) {
    StageArguments without = with_terms(arguments, asked, decisions.on);
    without.output = beside(arguments.output, decisions.on.empty() ? "_plain" : "_one_term");
    without.settings.emplace_back("simulate.branches=\"none\"");
    const Inputs inputs = read_as(asked, without);
    const SweepOutcome outcome = run(without, inputs, inputs.scope(), threads, group);
    group.restart();
    if (decide_more(outcome, asked, group, decisions)) continue;
    group.together([&] {
      if (group.leads()) copy_whole(without.output, arguments.output);
    });
    break;
  }
  return decisions;
}

/// Runs the speeds that break the symmetry, each from rest with all nodal diameters, into a response beside the
/// first. Settings that decide results are set as by --set, so that they enter the key of the run.
void run_whole_wheel(const Inputs& asked, StageArguments arguments, const std::vector<double>& speeds, int threads,
                     ProcessGroup& group) {
  arguments.output = beside(arguments.output, "_full");
  for (const char* setting : {"simulate.nodal_diameters=\"all\"", "simulate.sweep=\"rest\""})
    arguments.settings.emplace_back(setting);
  Inputs inputs = read_as(asked, arguments);
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

void run_simulate(const StageArguments& asked, int threads) {
  openblas_set_num_threads(1);  // this program's own threads share the speeds
  StageArguments arguments = asked;
  Inputs inputs = read_inputs(arguments);
  if (arguments.action == Action::check) {
    report_scope(arguments, inputs, inputs.scope());
    return;
  }
  ProcessGroup group;
  if (group.leads()) say_blas(arguments);
  std::vector<std::string> decided;
  if (!inputs.open.empty()) {
    const Decisions decisions = decide_terms(arguments, inputs, threads, group);
    decided = decisions.reasons;
    if (group.leads())
      for (const std::string& reason : decided) say(arguments, reason);
    arguments = with_terms(arguments, inputs, decisions.on);
    inputs = read_as(inputs, arguments);
  }
  SceneScope scope = inputs.scope();
  scope.reasons.insert(scope.reasons.end(), decided.begin(), decided.end());
  const std::vector<double> breaking = run(arguments, inputs, scope, threads, group).breaking;
  if (inputs.parameters.when_symmetry_breaks == BrokenSymmetry::mark) return;
  if (breaking.empty()) {
    if (const std::filesystem::path full = beside(arguments.output, "_full");
        group.leads() && std::filesystem::exists(full))
      say(arguments,
          full.string() + " is left as it is: it is of an earlier run, and no speed breaks the symmetry now");
    return;
  }
  group.restart();
  run_whole_wheel(inputs, arguments, breaking, threads, group);
}

}  // namespace tiprub::simulate
