// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/study.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cases/program/errors.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

void check_speed(const SpeedResponse& at, const std::string& name) {
  const std::string where = name + ": the speed " + rpm_text(at.speed) + " ";
  if (!(at.speed > 0)) throw RunError(where + "must be above 0");
  if (at.recorded_revolutions < 1 || at.samples_per_revolution < 1 || at.steps_per_revolution < 1)
    throw RunError(where + "holds no whole revolution");
  if (at.contact_count.cols() < 1) throw RunError(where + "has no contact areas");
}

std::vector<SpeedResponse> take_failed(Response& response) {
  auto& speeds = response.speeds;
  const auto first =
      std::stable_partition(speeds.begin(), speeds.end(), [](const SpeedResponse& at) { return at.failure.empty(); });
  std::vector<SpeedResponse> failed(std::make_move_iterator(first), std::make_move_iterator(speeds.end()));
  speeds.erase(first, speeds.end());
  return failed;
}

/// Peaks over speed of every wave on a whole engine order, as far as the maps' colours reach down.
std::vector<Ridge> find_ridges(const InteractionMap& map, const FrequencyCurves& curves, int sector_count,
                               const PostprocessParameters& parameters) {
  const double floor = map.largest() * std::pow(10.0, -parameters.amplitude_decades);
  std::vector<Ridge> ridges;
  for (int order = 1; order <= parameters.engine_order_max; ++order)
    for (int column = 0; column < sector_count; ++column) {
      const int n = signed_nodal_diameter(column, sector_count);
      const Eigen::VectorXd curve = map.wave(order, n);
      for (const Peak& peak : find_peaks(curve, parameters.prominence)) {
        if (curve[peak.index] < floor) continue;
        const double speed = map.columns[static_cast<std::size_t>(peak.index)].speed;
        ridges.push_back({speed, label_wave(curves, sector_count, speed, order, n, curve[peak.index])});
      }
    }
  return ridges;
}

/// See Study::shown.
Eigen::Index shown_speed(const Study& study) {
  const auto& speeds = study.response.speeds;
  Eigen::Index shown = -1;
  const double asked = study.parameters.shown_speed_rpm;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(speeds.size()); ++i) {
    const auto far = [&](Eigen::Index k) {
      return std::abs(speeds[static_cast<std::size_t>(k)].speed * rpm_per_rad_s - asked);
    };
    const bool better = asked > 0 ? shown < 0 || far(i) < far(shown)
                                  : speeds[static_cast<std::size_t>(i)].motion == MotionClass::periodic &&
                                        (shown < 0 || study.amplitudes.largest[i] > study.amplitudes.largest[shown]);
    if (better) shown = i;
  }
  return shown < 0 ? study.worst : shown;
}

Eigen::VectorXd speeds_of(const Response& response) {
  Eigen::VectorXd speeds(static_cast<Eigen::Index>(response.speeds.size()));
  for (Eigen::Index i = 0; i < speeds.size(); ++i) speeds[i] = response.speeds[static_cast<std::size_t>(i)].speed;
  return speeds;
}

}  // namespace

void check_together(const ReducedModel& model, const Response& response, const std::string& name) {
  const SimulatedScene& scene = response.scene;
  if (scene.sector_count != model.sector_count)
    throw InputError(name + ": has " + std::to_string(scene.sector_count) + " sectors, the model has " +
                     std::to_string(model.sector_count) + "; give the model that the response was made with");
  if (scene.clearance.size() != model.contact.size())
    throw InputError(name + ": has " + std::to_string(scene.clearance.size()) + " contact nodes, the model has " +
                     std::to_string(model.contact.size()) + "; give the model that the response was made with");
  if (response.speeds.empty()) throw RunError(name + ": holds no speed; run tiprub-simulate");
  bool usable = false;
  for (const SpeedResponse& at : response.speeds) {
    if (!at.failure.empty()) continue;
    check_speed(at, name);
    usable = true;
  }
  if (!usable)
    throw RunError(name + ": all " + std::to_string(response.speeds.size()) + " speeds failed; the first, " +
                   rpm_text(response.speeds.front().speed) + ", because: " + response.speeds.front().failure);
}

Study make_study(const PostprocessParameters& parameters, ReducedModel model, Response response) {
  std::vector<SpeedResponse> failed = take_failed(response);
  const SpeedRange range{response.speeds.front().speed, response.speeds.back().speed};
  FrequencyCurves curves(model, range.high);
  Study study{.parameters = parameters,
              .model = std::move(model),
              .response = std::move(response),
              .failed = std::move(failed),
              .range = range,
              .curves = std::move(curves)};
  const ContactLine& contact = study.model.contact;
  const int sector_count = study.model.sector_count;
  study.amplitudes = tip_amplitudes(study.response, contact, parameters.component);
  study.amplitudes.largest.maxCoeff(&study.worst);
  study.shown = shown_speed(study);
  study.map_node = parameters.edge == TipEdge::leading ? 0 : contact.size() - 1;
  study.map = interaction_map(study.response, contact, study.map_node, parameters.component);
  study.ridges = find_ridges(study.map, study.curves, sector_count, parameters);
  study.leading_edge = contact_map(study.response, 0);
  study.trailing_edge = contact_map(study.response, contact.size() - 1);
  const int lobes = std::max(study.response.scene.lobes, 1);
  study.leading_drift = contact_drift(study.leading_edge, speeds_of(study.response), lobes, contact);
  study.trailing_drift = contact_drift(study.trailing_edge, speeds_of(study.response), lobes, contact);
  study.critical = critical_speeds(study.response, contact, study.amplitudes, study.curves, parameters);
  study.equation_2 = equation_2_crossings(study.curves, sector_count, parameters.families, range);
  study.aliased = aliased_crossings(study.curves, sector_count, parameters.families, study.response.scene.lobes,
                                    parameters.engine_order_max, range);
  const std::vector<int>& moving = study.response.scene.nodal_diameters;
  study.equation_2_score =
      score(LinearRule::equation_2, study.equation_2, moving, parameters.prediction_tolerance, study.critical);
  study.aliasing_score =
      score(LinearRule::with_aliasing, study.aliased, moving, parameters.prediction_tolerance, study.critical);
  return study;
}

}  // namespace tiprub
