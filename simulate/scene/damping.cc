// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scene/damping.h"

#include <algorithm>
#include <optional>

namespace tiprub::simulate {

namespace {

constexpr double beyond_verified = 2;  // times the highest verified frequency

/// Of resolved modes.
std::vector<double> all_given(const DampingRatios& ratios) {
  if (ratios.by_frequency.empty()) return ratios.by_family;
  std::vector<double> given;
  for (const auto& [frequency, ratio] : ratios.by_frequency) given.push_back(ratio);
  return given;
}

}  // namespace

const Range damping_range = Range::between(0, 0.9);

double resolved_frequency(const ReducedModel& model) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::MatrixXd& frequencies : model.verification.unreduced)
    if (frequencies.size() > 0) lowest = std::min(lowest, frequencies.rightCols(1).minCoeff());
  return beyond_verified * lowest;
}

void Damping::set_beyond(double frequency, double ratio) {
  resolved_ = frequency;
  ratios_.beyond = ratio;
}

double Damping::ratio(std::size_t family, double frequency) const {
  if (frequency > resolved_) return ratios_.beyond;
  if (ratios_.by_frequency.empty()) return ratios_.by_family[std::min(family, ratios_.by_family.size() - 1)];
  return linear_between(ratios_.by_frequency, frequency);
}

double Damping::largest() const {
  const std::vector<double> given = all_given(ratios_);
  return *std::max_element(given.begin(), given.end());
}

double Damping::smallest() const {
  const std::vector<double> given = all_given(ratios_);
  return *std::min_element(given.begin(), given.end());
}

Damping read_damping(CaseTable& table) {
  const bool by_frequency = table.has("damping_table"), by_family = table.has("damping_ratio_by_family");
  if (by_frequency && by_family)
    table.reject("damping_table", "and damping_ratio_by_family exclude each other; drop one");
  if (by_frequency) return Damping(table.points("damping_table", std::nullopt, damping_range, "Hz, of critical"));
  if (by_family)
    return Damping(
        table.numbers("damping_ratio_by_family", std::nullopt, damping_range, "of critical, first family on"));
  return {table.number("damping_ratio", 0.005, damping_range, "of critical, every resolved mode")};
}

}  // namespace tiprub::simulate
