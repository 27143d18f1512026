// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/simulate_parameters.h"

#include <algorithm>
#include <numbers>

namespace tiprub {

namespace {

constexpr double rpm = 2 * std::numbers::pi / 60;
constexpr int count_max = 1'000'000;

std::vector<double> read_speeds(CaseTable& table) {
  std::vector<double> speeds;
  if (table.has("speeds_rpm")) {
    speeds = table.numbers("speeds_rpm", std::nullopt, Range::positive(), "rev/min");
    std::sort(speeds.begin(), speeds.end());
    if (std::adjacent_find(speeds.begin(), speeds.end()) != speeds.end())
      table.reject("speeds_rpm", "names a speed twice; drop one");
  } else {
    const double low = table.number("speed_min_rpm", std::nullopt, Range::positive(), "rev/min");
    const double high = table.number("speed_max_rpm", std::nullopt, Range::positive(), "rev/min");
    const int count = table.integer("speed_count", 40, Range::between(2, count_max), "speeds, evenly spaced");
    if (high <= low) table.reject("speed_max_rpm", "must be above speed_min_rpm");
    for (int i = 0; i < count; ++i) speeds.push_back(low + (high - low) * i / (count - 1));
  }
  for (double& speed : speeds) speed *= rpm;
  return speeds;
}

std::vector<double> read_damping(CaseTable& table) {
  if (table.has("damping_ratio_by_family"))
    return table.numbers("damping_ratio_by_family", std::nullopt, Range::at_least(0), "of critical, first family on");
  return {table.number("damping_ratio", 0.005, Range::at_least(0), "of critical, every mode")};
}

void read_revolutions(CaseTable& table, SimulateParameters& parameters) {
  parameters.recorded_revolutions = table.integer("recorded_revolutions", 6, Range::between(1, count_max), "");
  parameters.min_revolutions = table.integer("min_revolutions", 20, Range::between(1, count_max), "");
  parameters.max_revolutions = table.integer("max_revolutions", 200, Range::between(2, count_max), "");
  if (parameters.max_revolutions < parameters.min_revolutions)
    table.reject("max_revolutions", "must be at least min_revolutions");
  if (parameters.max_revolutions <= parameters.recorded_revolutions)
    table.reject("max_revolutions", "must be above recorded_revolutions, which it includes");
  parameters.settle_tolerance =
      table.number("settle_tolerance", 1e-4, {0.0, 1.0, Range::LowEnd::excluded}, "of the motion's norm");
}

}  // namespace

SimulateParameters read_simulate_parameters(CaseTable& table) {
  SimulateParameters parameters;
  parameters.speeds = read_speeds(table);
  parameters.scheme = table.choice<Scheme>(
      "scheme", Scheme::trigonometric,
      {{"trigonometric", Scheme::trigonometric}, {"central_differences", Scheme::central_differences}});
  parameters.contact =
      table.choice<ContactRule>("contact", ContactRule::complementarity,
                                {{"complementarity", ContactRule::complementarity}, {"paper", ContactRule::paper}});
  if (parameters.contact == ContactRule::paper && parameters.scheme != Scheme::central_differences)
    table.reject(
        "contact",
        "= \"paper\" holds only with scheme = \"central_differences\": with the larger steps of the "
        "trigonometric scheme its pulling forces blow up; set that scheme, or contact = \"complementarity\"");
  parameters.damping_ratios = read_damping(table);
  parameters.nodal_diameters =
      table.choice<DiameterChoice>("nodal_diameters", DiameterChoice::symmetric,
                                   {{"symmetric", DiameterChoice::symmetric}, {"all", DiameterChoice::all}});
  parameters.steps_per_period =
      table.number("steps_per_period", 400, Range::between(4, count_max), "of the lowest frequency, at least");
  parameters.steps_per_revolution =
      table.integer("steps_per_revolution", 0, Range::between(0, 100 * count_max), "at least; 0: from the period");
  parameters.samples_per_revolution =
      table.integer("samples_per_revolution", 240, Range::between(1, count_max), "at least");
  read_revolutions(table, parameters);
  parameters.casing_areas = table.integer("casing_areas", 200, Range::between(1, count_max), "around the casing");
  parameters.threads = table.integer("threads", 0, Range::between(0, 1024), "0: as many as the machine has");
  table.close();
  return parameters;
}

}  // namespace tiprub
