// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/simulate_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cases/program/text.h"
#include "cases/program/units.h"

namespace tiprub::simulate {

namespace {

constexpr int count_max = 1'000'000;
const Range accuracy_range = Range::between(1e-5, 0.5);

/// The steps in a period of the first march. The step is halved at least once, and the first halving tells the error.
/// On the wheels of cases/speed_accuracy 200 steps in a period of the first family, halved once, give errors below
/// 4e-3. Errors fall with the square of the step or, in hard impacts, with the step.
double steps_for(double tolerance) {
  constexpr double measured_tolerance = 5e-3, measured_steps = 200;
  return measured_steps * std::sqrt(measured_tolerance / tolerance);
}

std::vector<double> read_speeds(CaseTable& table) {
  std::vector<double> speeds;
  if (table.has("speeds_rpm")) {
    speeds = table.numbers("speeds_rpm", std::nullopt, Range::positive(), "rev/min");
    std::ranges::sort(speeds);
    if (std::ranges::adjacent_find(speeds) != speeds.end())
      table.reject("speeds_rpm", "names a speed twice; drop one");
    for (const char* key : {"speed_min_rpm", "speed_max_rpm", "speed_count"})
      if (table.has(key))
        table.reject(key,
                     std::string("belongs to a range of speeds, and speeds_rpm lists them; leave one of them out ") +
                         "(--set simulate." + key + "= removes this key)");
  } else {
    const double low = table.number("speed_min_rpm", std::nullopt, Range::positive(), "rev/min");
    const double high = table.number("speed_max_rpm", std::nullopt, Range::positive(), "rev/min");
    const int count = table.integer("speed_count", 40, Range::between(2, count_max), "speeds, evenly spaced");
    if (high <= low) {
      table.reject("speed_max_rpm", text_of("= ", high, " must be above speed_min_rpm = ", low));
    }
    for (int i = 0; i < count; ++i) speeds.push_back(low + (high - low) * i / (count - 1));
  }
  for (double& speed : speeds) speed *= rad_s_per_rpm;
  return speeds;
}

/// A ratio in percent is mostly beyond this range.
const Range usual_damping = Range::between(0, 0.05);

/// The key that gives the largest ratio.
const char* damping_key(const CaseTable& table, const Damping& damping) {
  for (const ModeDamping& mode : damping.ratios.by_mode)
    if (mode.ratio == damping.largest()) return "damping_by_mode";
  for (const char* key : {"damping_table", "damping_ratio_by_family"})
    if (table.has(key)) return key;
  return "damping_ratio";
}

constexpr double unresolved_damping = 0.02;  // of critical: a mode decays within a few of its periods

void read_damping_and_band(CaseTable& table, SimulateParameters& parameters) {
  parameters.damping = read_damping(table);
  parameters.unusual = table.flag("unusual", false);
  if (!parameters.unusual)
    require_usual(table, damping_key(table, parameters.damping), parameters.damping.largest(), usual_damping,
                  "of critical");
  parameters.resolved_frequency = table.number("resolved_frequency_hz", 0, Range::at_least(0),
                                               "Hz; 0: twice the highest at which the model was verified");
  parameters.damping_ratio_beyond =
      table.number("damping_ratio_beyond", std::max(unresolved_damping, parameters.damping.largest()), damping_range,
                   "of critical, every mode above the resolved frequency");
}

void read_revolutions(CaseTable& table, SimulateParameters& parameters) {
  parameters.recorded_revolutions = table.integer("recorded_revolutions", 6, Range::between(1, count_max), "");
  parameters.min_revolutions = table.integer("min_revolutions", 20, Range::between(1, count_max), "");
  parameters.max_revolutions = table.integer("max_revolutions", 200, Range::between(2, count_max), "");
  const auto most = [&](const auto&... rule) {
    return text_of("= ", parameters.max_revolutions, " must be ", rule...);
  };
  if (parameters.max_revolutions < parameters.min_revolutions)
    table.reject("max_revolutions", most("at least min_revolutions = ", parameters.min_revolutions));
  if (parameters.max_revolutions <= parameters.recorded_revolutions)
    table.reject("max_revolutions",
                 most("above recorded_revolutions = ", parameters.recorded_revolutions, ", which it includes"));
  parameters.settle_tolerance = table.number("settle_tolerance", parameters.accuracy / 200,
                                             {0.0, 1.0, Range::LowEnd::excluded}, "of the motion's norm");
  parameters.steady_state = table.choice("steady_state", SteadyStateMethod::march,
                                         {{SteadyStateMethod::march, "march"}, {SteadyStateMethod::orbit, "orbit"}});
}

void read_speed_choice(CaseTable& table, SimulateParameters& parameters) {
  parameters.speeds = read_speeds(table);
  parameters.speed_choice = table.choice("speeds", SpeedChoice::adaptive,
                                         {{SpeedChoice::given, "given"}, {SpeedChoice::adaptive, "adaptive"}});
  if (parameters.speeds.size() < 2) parameters.speed_choice = SpeedChoice::given;  // nothing lies between
  parameters.scan_per_interval = table.integer("scan_per_interval", 4, Range::between(0, 1000),
                                               "scanned speeds between two, at least, if adaptive");
  parameters.speed_count_max =
      table.integer("speed_count_max", std::max(1000, 4 * static_cast<int>(parameters.speeds.size())),
                    Range::between(2, count_max), "speeds, if adaptive");
  parameters.peak_prominence =
      table.number("peak_prominence", 0.1, {0, 1, Range::LowEnd::excluded}, "of a peak's own height");
  parameters.examination =
      table.choice("examine", Examination::critical_speeds,
                   {{Examination::critical_speeds, "critical_speeds"}, {Examination::none, "none"}});
}

void read_budget(CaseTable& table, SimulateParameters& parameters) {
  parameters.physics = table.choice("physics", PhysicsChoice::as_given,
                                    {{PhysicsChoice::as_given, "as_given"}, {PhysicsChoice::as_needed, "as_needed"}});
  const bool decides = parameters.physics == PhysicsChoice::as_needed;
  parameters.budget = table.choice("budget", decides ? BudgetChoice::critical_speeds : BudgetChoice::none,
                                   {{BudgetChoice::none, "none"},
                                    {BudgetChoice::largest, "largest"},
                                    {BudgetChoice::critical_speeds, "critical_speeds"}});
  if (parameters.budget == BudgetChoice::none) {
    for (const char* key : {"budget_friction", "budget_damping", "budget_clearance", "budget_model"})
      table.only_with(key, "budget = \"critical_speeds\" or \"largest\"");
    return;
  }
  parameters.budget_friction = table.number("budget_friction", 0.1, Range::at_least(0), "of the contact force");
  parameters.budget_damping = table.numbers("budget_damping", std::vector<double>{2e-3, 5e-3}, damping_range,
                                            "of critical, each in turn, of all resolved modes");
  parameters.budget_clearance =
      table.number("budget_clearance", 20e-6, Range::positive(), "m, tolerance of the clearance");
  parameters.budget_model = table.text("budget_model", "");
  if (parameters.examination == Examination::none) parameters.budget = BudgetChoice::none;
}

/// The decision rests on error budgets, which only examined critical speeds have.
void require_budgets_to_decide_by(const CaseTable& table, const SimulateParameters& parameters) {
  if (parameters.physics == PhysicsChoice::as_given) return;
  const auto reject = [&](const char* instead) {
    table.reject("physics", std::string("= \"as_needed\" ") + instead + ", or leave physics out");
  };
  if (parameters.sweep != SweepDirection::rest)
    reject("decides by critical speeds, which only a sweep from rest examines; set sweep = \"rest\"");
  if (parameters.examination == Examination::none)
    reject("decides by critical speeds; set examine = \"critical_speeds\"");
  if (parameters.budget == BudgetChoice::none)
    reject("decides by error budgets; set budget = \"critical_speeds\" or \"largest\"");
  if (parameters.contact == ContactRule::paper)
    reject("needs forces that only push; set contact = \"complementarity\"");
}

/// Refuses keys that ask for periodic motions; `what` says why, and begins to say what to set.
void refuse_orbits(const CaseTable& table, const SimulateParameters& parameters, const std::string& what) {
  if (parameters.steady_state == SteadyStateMethod::orbit)
    table.reject("steady_state", "= \"orbit\"" + what + "steady_state = \"march\"");
  const char* const asked = parameters.branches == BranchChoice::speeds ? "speeds" : "critical_speeds";
  if (parameters.branches != BranchChoice::none)
    table.reject("branches", text_of("= \"", asked, "\"", what, "branches = \"none\""));
}

/// Packagers may leave out Trilinos, which finds periodic motions. The modes at two instants must determine an orbit,
/// which rules out contact laws with memory.
void require_that_orbits_can_be_found(const CaseTable& table, const SimulateParameters& parameters) {
#ifdef TIPRUB_WITHOUT_ORBITS
  refuse_orbits(table, parameters, " needs a build with TIPRUB_ORBITS=ON; set ");
#endif
  if (!maps_states(parameters.scheme, parameters.contact))
    refuse_orbits(table, parameters,
                  " holds only with contact = \"complementarity\" and neither scheme = \"moreau_jean\" nor "
                  "\"penalty\"; set another scheme, or ");
}

void read_branches(CaseTable& table, SimulateParameters& parameters) {
  parameters.branches = table.choice("branches", BranchChoice::none,
                                     {{BranchChoice::none, "none"},
                                      {BranchChoice::critical_speeds, "critical_speeds"},
                                      {BranchChoice::speeds, "speeds"}});
  parameters.branch_range =
      table.number("branch_range", 0.03, {0, 0.5, Range::LowEnd::excluded}, "of a speed, to either side");
  parameters.branch_steps = table.integer("branch_steps", 60, Range::between(1, 10000), "to either side, at most");
}

void read_scheme(CaseTable& table, SimulateParameters& parameters) {
  parameters.scheme = table.choice("scheme", Scheme::trigonometric, scheme_names);
  parameters.contact = table.choice("contact", ContactRule::complementarity, contact_rule_names);
  if (parameters.contact == ContactRule::paper && parameters.scheme != Scheme::central_differences)
    table.reject("contact",
                 "= \"paper\" holds only with scheme = \"central_differences\": with the larger steps of the "
                 "trigonometric scheme its pulling forces grow without bound; set that scheme, or contact = "
                 "\"complementarity\"");
  parameters.gap = table.choice(
      "gap", GapOrder::automatic,
      {{GapOrder::automatic, "automatic"}, {GapOrder::linear, "linear"}, {GapOrder::second_order, "second_order"}});
  if (parameters.scheme == Scheme::moreau_jean)
    parameters.theta = table.number("moreau_jean_theta", 0.5, Range::between(0.5, 1), "1/2 conserves, more damps");
  else
    table.only_with("moreau_jean_theta", "scheme = \"moreau_jean\"");
  if (parameters.scheme == Scheme::penalty)
    parameters.penalty_stiffness =
        table.number("penalty_stiffness", 100, Range::positive(), "static stiffnesses of the stiffest contact node");
  else
    table.only_with("penalty_stiffness", "scheme = \"penalty\"");
  const bool needs_modes = traits_of(parameters.scheme).quasi_static;
  parameters.modes =
      table.integer("modes", needs_modes ? std::nullopt : std::optional<int>(0),
                    Range::between(needs_modes ? 1 : 0, count_max), "with mass, a nodal diameter; 0: all");
}

/// [Hz] Of the unreduced sector, or of the model at rest if that came without verification.
double lowest_frequency(const ReducedModel& model) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::MatrixXd& frequencies : model.verification.unreduced)
    if (frequencies.size() > 0) lowest = std::min(lowest, frequencies.minCoeff());
  if (std::isfinite(lowest)) return lowest;
  for (const NodalDiameterModel& matrices : model.nodal_diameters)
    lowest = std::min(lowest, matrices.natural_frequencies(0).minCoeff());
  return lowest;
}

}  // namespace

SimulateParameters read_simulate_parameters(CaseTable& table) {
  SimulateParameters parameters;
  parameters.accuracy = table.number("accuracy", 0.02, accuracy_range, "of a critical speed's amplitude");
  read_speed_choice(table, parameters);
  read_budget(table, parameters);
  read_scheme(table, parameters);
  read_damping_and_band(table, parameters);
  parameters.nodal_diameters = table.choice("nodal_diameters", DiameterChoice::symmetric,
                                            {{DiameterChoice::symmetric, "symmetric"}, {DiameterChoice::all, "all"}});
  parameters.step_tolerance =
      table.number("step_tolerance", parameters.accuracy / 4, Range::between(1e-7, 0.5), "of the settled motion");
  parameters.steps_per_period = table.number("steps_per_period", steps_for(parameters.step_tolerance),
                                             Range::between(4, count_max), "of the lowest frequency, at least");
  parameters.steps_per_revolution =
      table.integer("steps_per_revolution", 0, Range::between(0, 100 * count_max), "at least; 0: from the period");
  parameters.samples_per_revolution = table.integer("samples_per_revolution", 240, Range::between(2, count_max),
                                                    "at least; default: at least 20 a lobe");
  if (!table.has("samples_per_revolution")) parameters.samples_per_lobe = 20;
  read_revolutions(table, parameters);
  read_branches(table, parameters);
  require_that_orbits_can_be_found(table, parameters);
  parameters.casing_areas = table.integer("casing_areas", 200, Range::between(1, 100000), "around the casing");
  parameters.threads = table.integer("threads", 0, Range::between(0, 1024), "0: as many as the machine has");
  parameters.sweep =
      table.choice("sweep", SweepDirection::rest,
                   {{SweepDirection::rest, "rest"}, {SweepDirection::up, "up"}, {SweepDirection::down, "down"}});
  require_budgets_to_decide_by(table, parameters);
  parameters.symmetry_check_revolutions =
      table.integer("symmetry_check_revolutions", 24, Range::between(0, count_max), "0: no check");
  parameters.when_symmetry_breaks =
      table.choice("when_symmetry_breaks", BrokenSymmetry::mark,
                   {{BrokenSymmetry::mark, "mark"}, {BrokenSymmetry::full_run, "full_run"}});
  table.close();
  return parameters;
}

void require_units_of_model(const CaseTable& table, const SimulateParameters& parameters, const ReducedModel& model) {
  constexpr double least_share = 1.0 / 9;  // of the model's range: less than the ratio of rad/s to rev/min
  if (parameters.unusual) return;
  require_usual(table, table.has("speeds_rpm") ? "speeds_rpm" : "speed_max_rpm",
                parameters.speeds.back() * rpm_per_rad_s,
                Range::at_least(least_share * model.speed_max * rpm_per_rad_s), "rev/min");
  if (parameters.resolved_frequency > 0)
    require_usual(table, "resolved_frequency_hz", parameters.resolved_frequency,
                  Range::at_least(lowest_frequency(model)), "Hz");
}

void require_gap_of_model(const CaseTable& table, const SimulateParameters& parameters, const ReducedModel& model) {
  if (parameters.gap != GapOrder::second_order || model.contact.second_order) return;
  table.reject("gap",
               "= \"second_order\" needs /contact/second_order in the model, which tiprub-reduce writes for "
               "sectors of finite elements; reduce the sector again, or set gap = \"linear\"");
}

void fit_to_model(SimulateParameters& parameters, const ReducedModel& model) {
  if (parameters.gap == GapOrder::automatic)
    parameters.gap = model.contact.second_order ? GapOrder::second_order : GapOrder::linear;
  if (parameters.resolved_frequency == 0) parameters.resolved_frequency = resolved_frequency(model);
  parameters.damping.resolved_frequency = parameters.resolved_frequency;
  parameters.damping.ratios.beyond = parameters.damping_ratio_beyond;
}

}  // namespace tiprub::simulate
