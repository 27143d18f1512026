// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/damping.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "cases/program/text.h"

namespace tiprub::simulate {

namespace {

constexpr double beyond_verified = 2;  // times the highest verified frequency

/// Of modes up to the frequency `resolved` [Hz].
std::vector<double> all_given(const DampingRatios& ratios, double resolved) {
  std::vector<double> given = ratios.by_family;
  for (const auto& [frequency, ratio] : ratios.by_frequency)
    given.push_back(frequency > resolved ? linear_between(ratios.by_frequency, resolved) : ratio);
  for (const ModeDamping& mode : ratios.by_mode) given.push_back(mode.ratio);
  return given;
}

constexpr const char* modes_key = "damping_by_mode";

std::vector<ModeDamping> read_modes(CaseTable& table) {
  constexpr int count_max = 1'000'000;
  std::vector<ModeDamping> modes;
  const auto rows = table.rows(modes_key, 3, damping_range, "nodal diameter, family from 1, of critical");
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double n = rows[row][0], family = rows[row][1];
    if (!(n >= 0 && n < count_max && n == std::floor(n)))
      table.reject(modes_key, "must begin with a nodal diameter, a whole number from 0 on", row);
    if (!(family >= 1 && family < count_max && family == std::floor(family)))
      table.reject(modes_key, "must have a family second, a whole number from 1 on", row);
    const ModeDamping mode{static_cast<int>(n), static_cast<int>(family) - 1, rows[row][2]};
    for (const ModeDamping& other : modes)
      if (other.nodal_diameter == mode.nodal_diameter && other.family == mode.family)
        table.reject(modes_key, "has this mode twice; drop one", row);
    modes.push_back(mode);
  }
  return modes;
}

DampingRatios read_damping_of_the_rest(CaseTable& table) {
  std::vector<std::string> given;
  for (const char* key : {"damping_ratio", "damping_ratio_by_family", "damping_table"})
    if (table.has(key)) given.emplace_back(key);
  if (given.size() > 1)
    table.reject(given[1],
                 "and " + given[0] + " exclude each other; drop one (--set simulate." + given[0] + "= drops it)");
  const std::string key = given.empty() ? "damping_ratio" : given.front();
  if (key == "damping_table")
    return {.by_frequency = table.points("damping_table", std::nullopt, damping_range, "Hz, of critical")};
  if (key == "damping_ratio_by_family")
    return {.by_family = table.numbers("damping_ratio_by_family", std::nullopt, damping_range,
                                       "of critical, first family on")};
  return {.by_family = {table.number(key, 0.005, damping_range, "of critical, every resolved mode")}};
}

}  // namespace

const Range damping_range = Range::between(0, 0.9);

double resolved_frequency(const ReducedModel& model) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::MatrixXd& frequencies : model.verification.unreduced)
    if (frequencies.size() > 0) lowest = std::min(lowest, frequencies.rightCols(1).minCoeff());
  return beyond_verified * lowest;
}

double Damping::ratio(int nodal_diameter, int family, double frequency) const {
  if (frequency > resolved_frequency) return ratios.beyond;
  for (const ModeDamping& mode : ratios.by_mode)
    if (mode.nodal_diameter == nodal_diameter && mode.family == family) return mode.ratio;
  if (!ratios.by_frequency.empty()) return linear_between(ratios.by_frequency, frequency);
  return ratios.by_family[std::min(static_cast<std::size_t>(family), ratios.by_family.size() - 1)];
}

double Damping::largest() const {
  return std::ranges::max(all_given(ratios, resolved_frequency));
}

double Damping::smallest() const {
  return std::ranges::min(all_given(ratios, resolved_frequency));
}

Damping read_damping(CaseTable& table) {
  Damping damping;
  damping.ratios = read_damping_of_the_rest(table);
  if (table.has(modes_key)) damping.ratios.by_mode = read_modes(table);
  return damping;
}

void require_modes_of_wheel(const CaseTable& table, const Damping& damping, const ReducedModel& model) {
  const std::vector<ModeDamping>& modes = damping.ratios.by_mode;
  std::map<int, Eigen::VectorXd> lowest;  // [Hz] at rest or at the highest speed, by nodal diameter
  for (std::size_t row = 0; row < modes.size(); ++row) {
    const int n = modes[row].nodal_diameter, most = model.nodal_diameter_max();
    if (n > most)
      table.reject(modes_key,
                   "has nodal diameter " + std::to_string(n) + ", and a wheel of " +
                       std::to_string(model.sector_count) + " sectors has 0 to " + std::to_string(most),
                   row);
    if (const auto families = model.nodal_diameters[static_cast<std::size_t>(n)].M.rows();
        modes[row].family >= families)
      table.reject(modes_key,
                   "has family " + std::to_string(modes[row].family + 1) + ", and the model has " +
                       std::to_string(families) + " on nodal diameter " + std::to_string(n),
                   row);
    if (!lowest.contains(n)) {
      const NodalDiameterModel& of_n = model.nodal_diameters[static_cast<std::size_t>(n)];
      lowest[n] = of_n.natural_frequencies(0).cwiseMin(of_n.natural_frequencies(model.speed_max));
    }
    if (const double frequency = lowest[n][modes[row].family]; frequency > damping.resolved_frequency)
      table.reject(modes_key,
                   text_of("has family ", modes[row].family + 1, " of nodal diameter ", n, ", of at least ",
                           frequency, " Hz, above the resolved frequency, ", damping.resolved_frequency,
                           " Hz, where damping_ratio_beyond holds; drop the row"),
                   row);
  }
}

}  // namespace tiprub::simulate
