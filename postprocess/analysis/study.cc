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
  const ContactLine& contact = model.contact;
  std::vector<SpeedResponse> failed =
      take_others(response.speeds, [](const SpeedResponse& speed) { return speed.failure.empty(); });
  const SpeedRange range{response.speeds.front().speed, response.speeds.back().speed};
  const FrequencyCurves curves(response.frequencies);
  TipAmplitudes amplitudes = tip_amplitudes(response, contact, parameters.component);
  WaveMaps waves = wave_maps(response, contact, curves, parameters);
  std::vector<CriticalSpeed> critical = critical_speeds(response, contact, amplitudes, curves, parameters);
  std::vector<CriticalSpeed> not_located =
      take_others(critical, [](const CriticalSpeed& peak) { return peak.located; });
  std::vector<GapTerms> gap;
  for (const SpeedResponse& speed : response.speeds) gap.push_back(gap_terms(speed, response.scene, contact));
  LinearRules rules = linear_rules(response, contact, curves, amplitudes, critical, parameters);
  critical = with_predictions(std::move(critical), rules, parameters.prediction_tolerance);
  ContactMaps contact_places = contact_maps(response, contact);
  std::vector<SweepComparison> compared =
      compare_sweeps(response, contact, waves.first().node, parameters.component, sweeps);
  const Eigen::Index shown = shown_speed(response, amplitudes, parameters.shown_speed_rpm);
  return {parameters,
          std::move(model),
          std::move(response),
          std::move(failed),
          range,
          curves,
          std::move(amplitudes),
          std::move(waves),
          std::move(contact_places),
          std::move(critical),
          std::move(not_located),
          std::move(gap),
          std::move(rules),
          std::move(compared),
          shown};
}

}  // namespace tiprub::postprocess
