// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/study.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

/// Takes out what does not satisfy a condition.
template <class Item, class Condition>
std::vector<Item> take_others(std::vector<Item>& items, const Condition& stays) {
  const auto first = std::stable_partition(items.begin(), items.end(), stays);
  std::vector<Item> others(std::make_move_iterator(first), std::make_move_iterator(items.end()));
  items.erase(first, items.end());
  return others;
}

/// See Study::shown.
Eigen::Index shown_speed(const Response& response, const TipAmplitudes& amplitudes, double asked_rpm) {
  const auto& speeds = response.speeds;
  Eigen::Index shown = -1;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(speeds.size()); ++i) {
    const auto far = [&](Eigen::Index k) {
      return std::abs(speeds[static_cast<std::size_t>(k)].speed * rpm_per_rad_s - asked_rpm);
    };
    const bool better = asked_rpm > 0 ? shown < 0 || far(i) < far(shown)
                                      : speeds[static_cast<std::size_t>(i)].motion == MotionClass::periodic &&
                                            (shown < 0 || amplitudes.largest[i] > amplitudes.largest[shown]);
    if (better) shown = i;
  }
  return shown < 0 ? amplitudes.worst() : shown;
}

}  // namespace

const SpeedResponse& Study::judged_response() const {
  const std::optional<std::size_t> largest = largest_critical(critical);
  return largest ? speed_at(critical[*largest].index) : worst_response();
}

LengthRange Study::interference() const {
  LengthRange all;
  for (const SpeedResponse& speed : response.speeds) {
    const Eigen::VectorXd here = response.scene.interference(speed.clearance);
    all = {std::min(all.low, here.minCoeff()), std::max(all.high, here.maxCoeff())};
  }
  return all;
}

Study make_study(const PostprocessParameters& parameters, ReducedModel model, Response response,
                 const SweepFiles& sweeps) {
  const FrequencyCurves curves(response.frequencies);
  Study study{.parameters = parameters, .model = std::move(model), .response = std::move(response), .curves = curves};
  const ContactLine& contact = study.model.contact;
  const Response& all = study.response;
  study.failed = take_others(study.response.speeds, [](const SpeedResponse& speed) { return speed.failure.empty(); });
  study.range = {all.speeds.front().speed, all.speeds.back().speed};
  study.amplitudes = tip_amplitudes(all, contact, parameters.component);
  study.waves = wave_maps(all, contact, curves, parameters);
  study.critical = critical_speeds(all, contact, study.amplitudes, curves, parameters);
  study.not_located = take_others(study.critical, [](const CriticalSpeed& peak) { return peak.located; });
  for (const SpeedResponse& speed : all.speeds) study.gap.push_back(gap_terms(speed, all.scene, contact));
  study.rules = linear_rules(all, contact, curves, study.amplitudes, study.critical, parameters);
  study.critical = with_predictions(std::move(study.critical), study.rules, parameters.prediction_tolerance);
  study.contact = contact_maps(all, contact);
  study.sweeps = compare_sweeps(all, contact, study.waves.first().node, parameters.component, sweeps);
  study.shown = shown_speed(all, study.amplitudes, parameters.shown_speed_rpm);
  return study;
}

}  // namespace tiprub::postprocess
