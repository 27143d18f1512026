// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/study.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

std::vector<SpeedResponse> take_failed(Response& response) {
  auto& speeds = response.speeds;
  const auto first = std::stable_partition(speeds.begin(), speeds.end(),
                                           [](const SpeedResponse& speed) { return speed.failure.empty(); });
  std::vector<SpeedResponse> failed(std::make_move_iterator(first), std::make_move_iterator(speeds.end()));
  speeds.erase(first, speeds.end());
  return failed;
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

void measure_amplitudes(Study& study) {
  study.amplitudes = tip_amplitudes(study.response, study.model.contact, study.parameters.component);
  study.amplitudes.largest.maxCoeff(&study.worst);
  study.shown = shown_speed(study);
}

void map_waves(Study& study) {
  const auto map_of = [&](TipEdge edge) {
    const int node = edge == TipEdge::leading ? 0 : study.model.contact.trailing_edge();
    return interaction_map(study.response, study.model.contact, node, study.parameters.component);
  };
  study.map = map_of(study.parameters.edge);
  study.other_map = map_of(other_than(study.parameters.edge));
  study.ridges = find_ridges(study.map, study.curves, study.model.sector_count, study.parameters);
}

void map_contact(Study& study) {
  const ContactLine& contact = study.model.contact;
  const int lobes = std::max(study.response.scene.lobes, 1);
  const Eigen::VectorXd speeds = speeds_of(study.response);
  study.leading_edge = contact_map(study.response, contact, 0);
  study.trailing_edge = contact_map(study.response, contact, contact.trailing_edge());
  study.leading_drift = contact_drift(study.leading_edge, speeds, lobes, contact);
  study.trailing_drift = contact_drift(study.trailing_edge, speeds, lobes, contact);
  study.edge_lag = edge_lag(study.response, contact);
}

void find_critical_speeds(Study& study) {
  study.critical =
      critical_speeds(study.response, study.model.contact, study.amplitudes, study.curves, study.parameters);
}

/// Over all that moves, not what is drawn: a score must not depend on the drawing.
void score_linear_rules(Study& study) {
  const SimulatedScene& scene = study.response.scene;
  const int sectors = study.model.sector_count;
  const double tolerance = study.parameters.prediction_tolerance;
  const std::vector<TravellingSpectrum> waves =
      largest_waves(study.response, study.model.contact, study.parameters.component);
  study.moving =
      moving_waves(study.response, waves, study.curves, study.critical, study.amplitudes.largest[study.worst]);
  study.equation_2 = equation_2_crossings(study.curves, sectors, study.moving.families, study.range);
  study.aliased = aliased_crossings(study.curves, sectors, study.moving.families, scene.lobes,
                                    study.moving.engine_orders, study.range);
  read_amplitudes(study.equation_2, study.response, waves);
  read_amplitudes(study.aliased, study.response, waves);
  study.equation_2_score =
      score(LinearRule::equation_2, study.equation_2, scene.nodal_diameters, tolerance, study.critical);
  study.aliasing_score =
      score(LinearRule::with_aliasing, study.aliased, scene.nodal_diameters, tolerance, study.critical);
}

}  // namespace

const SpeedResponse& Study::judged_response() const {
  const auto most =
      std::max_element(critical.begin(), critical.end(),
                       [](const CriticalSpeed& a, const CriticalSpeed& b) { return a.amplitude < b.amplitude; });
  return most == critical.end() ? worst_response() : response.speeds[static_cast<std::size_t>(most->index)];
}

Study make_study(const PostprocessParameters& parameters, ReducedModel model, Response response,
                 const SweepFiles& sweeps) {
  std::vector<SpeedResponse> failed = take_failed(response);
  const SpeedRange range{response.speeds.front().speed, response.speeds.back().speed};
  FrequencyCurves curves(response.frequencies);
  Study study{.parameters = parameters,
              .model = std::move(model),
              .response = std::move(response),
              .failed = std::move(failed),
              .range = range,
              .curves = std::move(curves)};
  measure_amplitudes(study);
  map_waves(study);
  map_contact(study);
  find_critical_speeds(study);
  score_linear_rules(study);
  study.sweeps = compare_sweeps(study.response, study.model.contact, study.map.node, parameters.component, sweeps);
  return study;
}

}  // namespace tiprub
