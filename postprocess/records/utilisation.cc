// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/utilisation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tiprub::postprocess {

namespace {

/// A cycle with a utilisation, and the place of its speed in the response.
struct RatedCycle {
  Eigen::Index index;
  const StressCycle* cycle;
};

std::vector<RatedCycle> rated_cycles(const Study& study, const FieldResults& fields) {
  std::vector<RatedCycle> rated;
  const auto add = [&](const std::optional<FieldPeak>& peak, Eigen::Index index) {
    if (peak && peak->cycle && peak->cycle->goodman) rated.push_back({index, &*peak->cycle});
  };
  for (std::size_t i = 0; i < study.critical.size(); ++i) add(fields.peaks[i], study.critical[i].index);
  add(fields.of_no_critical, study.amplitudes.worst());
  std::erase_if(rated, [&](const RatedCycle& at) { return !(fields.over_speed[at.index] > 0); });
  return rated;
}

}  // namespace

Eigen::VectorXd utilisation_over_speed(const Study& study, const FieldResults& fields) {
  const Eigen::VectorXd& estimate = fields.over_speed;
  if (estimate.size() == 0) return {};
  const std::vector<RatedCycle> rated = rated_cycles(study, fields);
  if (rated.empty()) return {};
  Eigen::VectorXd utilisation(estimate.size());
  for (Eigen::Index k = 0; k < estimate.size(); ++k) {
    const auto [index, cycle] = *std::ranges::min_element(rated, {}, [&](const RatedCycle& at) {
      return std::abs(study.speed_at(at.index).speed - study.speed_at(k).speed);
    });
    utilisation[k] =
        index == k
            ? *cycle->goodman
            : goodman_utilisation(*cycle->strength, cycle->alternating * estimate[k] / estimate[index], cycle->mean);
  }
  return utilisation;
}

std::optional<std::size_t> worst_critical(const Study& study, const FieldResults& fields) {
  const auto severity = [&](std::size_t i) {
    const std::optional<FieldPeak>& stress = fields.peaks[i];
    return std::array{stress && stress->cycle ? stress->cycle->goodman.value_or(0) : 0.0,
                      stress ? stress->body.vibration : 0.0, study.critical[i].amplitude};
  };
  std::optional<std::size_t> worst;
  for (std::size_t i = 0; i < study.critical.size(); ++i)
    if (!worst || severity(i) > severity(*worst)) worst = i;
  return worst;
}

}  // namespace tiprub::postprocess
