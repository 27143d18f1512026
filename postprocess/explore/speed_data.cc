// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/explore/page_data.h"

#include <algorithm>
#include <array>

#include "postprocess/fields/field_study.h"
#include "postprocess/figures/maps.h"
#include "postprocess/records/error_budget_record.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/records/speeds_to_avoid.h"
#include "postprocess/records/study_records.h"
#include "postprocess/tables/packing.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

using nlohmann::json;

struct Edge {
  const char* name;
  const InteractionMap& map;
  const ContactMap& contact;
};

std::vector<Edge> edges_of(const WaveMaps& waves, const ContactMaps& contact) {
  return {{"leading", waves.leading, contact.leading}, {"trailing", waves.trailing, contact.trailing}};
}

/// The component's name in the case file.
const char* key_of(Component component) {
  return std::array{"normal", "radial", "tangential", "axial"}[static_cast<std::size_t>(component)];
}

/// The columns of the sectors that the response holds; the others move as these do.
Eigen::MatrixXd held(const SimulatedScene& scene, const Eigen::MatrixXd& of_all_sectors) {
  return of_all_sectors.leftCols(scene.independent_sectors);
}

void add_motion(PackedArrays& arrays, const Study& study, const SpeedResponse& speed, int node,
                const std::string& place) {
  const auto motion = [&](Component component) -> Eigen::MatrixXd {
    return mm_per_m *
           held(study.response.scene, tip_motion(speed, study.response.scene, study.model.contact, node, component));
  };
  arrays.add_coarse(place + "normal", motion(Component::normal));
  arrays.add_coarse(place + "tangential", motion(Component::tangential));
  if (study.parameters.component != Component::normal && study.parameters.component != Component::tangential)
    arrays.add_coarse(place + key_of(study.parameters.component), motion(study.parameters.component));
}

/// How many lines of a spectrum are drawn: as high as the maps reach, and at least the engine orders asked for.
int drawn_lines(const SpeedFrame& frame, const TravellingSpectrum& spectrum, double speed) {
  const double orders = std::max<double>(frame.engine_order_max, map_frequency_high(frame) / (speed * hz_per_rad_s));
  return std::min(spectrum.lines(), static_cast<int>(orders * spectrum.revolutions) + 1);
}

json add_speed(PackedArrays& arrays, const Study& study, const FieldResults& fields,
               const Eigen::VectorXd& utilisation, const SpeedFrame& frame, Eigen::Index i) {
  const SpeedResponse& speed = study.response.speeds[static_cast<std::size_t>(i)];
  const std::vector<Edge> edges = edges_of(study.waves, study.contact);
  const TravellingSpectrum& spectrum = edges[0].map.columns[static_cast<std::size_t>(i)].spectrum;
  const int lines = drawn_lines(frame, spectrum, speed.speed);
  for (const Edge& edge : edges) {
    const std::string place = std::to_string(i) + "/" + edge.name + "/";
    add_motion(arrays, study, speed, edge.map.node, place);
    arrays.add_coarse(place + "force",
                      held(study.response.scene, tip_force(speed, study.response.scene, edge.map.node)));
    const Eigen::MatrixXd& amplitude = edge.map.columns[static_cast<std::size_t>(i)].spectrum.amplitude;
    arrays.add(place + "spectrum", mm_per_m * amplitude.topRows(lines));
    arrays.add(place + "contact", edge.contact.share.col(i));
  }
  const Eigen::MatrixXd& by_node = study.amplitudes.by_node;
  return {{"rpm", speed.speed * rpm_per_rad_s},
          {"largest", study.amplitudes.largest[i] * mm_per_m},
          {"leading", by_node(0, i) * mm_per_m},
          {"trailing", by_node(study.model.contact.trailing_edge(), i) * mm_per_m},
          {"excursion", study.excursion_at(i) * mm_per_m},
          {"stress", fields.over_speed.size() > 0 ? json(fields.over_speed[i] * mpa_per_pa) : json()},
          {"goodman", utilisation.size() > 0 ? json(utilisation[i]) : json()},
          {"motion", motion_text(speed)},
          {"settled", speed.settled()},
          {"step_error", step_error(speed, study.response.scene.asked).value_or(0)},
          {"outside", study.gap[static_cast<std::size_t>(i)].beyond()
                          ? json(study.gap[static_cast<std::size_t>(i)].in_words())
                          : json()},
          {"samples", speed.samples_per_revolution},
          {"revolutions", speed.recorded_revolutions},
          {"period", speed.period_revolutions},
          {"lines", lines},
          {"clearance",
           {speed.clearance[0] * mm_per_m, speed.clearance[study.model.contact.trailing_edge()] * mm_per_m}}};
}

/// "586 MPa of the vibration, 643 MPa with spin; main blade near the root; Goodman's utilisation 1.23"
json stress_of(const std::optional<FieldPeak>& peak) {
  if (!peak) return {};
  return (peak->cycle ? "" : "at least ") + mpa_text(peak->body.vibration) + " of the vibration, " +
         mpa_text(peak->body.both) + " with spin" + (peak->where.empty() ? "" : "; " + peak->where) +
         (peak->cycle && peak->cycle->goodman ? "; Goodman's utilisation " + fixed(*peak->cycle->goodman, 2) : "");
}

/// [1] of what the budget of a critical speed leaves open of each quantity, the least certain first; null without
/// one.
json open_of(const std::vector<ErrorBudget>& budgets, const CriticalSpeed& critical) {
  const auto found = std::ranges::find(budgets, &critical, &ErrorBudget::critical);
  if (found == budgets.end()) return {};
  json list = json::array();
  for (const OpenQuantity& open : open_quantities(*found)) list.push_back({open.what, open.together});
  return list;
}

json goodman_of(const std::optional<FieldPeak>& peak) {
  return peak && peak->cycle && peak->cycle->goodman ? json(*peak->cycle->goodman) : json();
}

json critical_of(const Study& study, const FieldResults& fields) {
  const std::vector<CriticalSpeed>& all = study.critical;
  const std::vector<ErrorBudget> budgets = error_budgets(study, fields);
  json list = json::array();
  for (std::size_t i = 0; i < all.size(); ++i)
    list.push_back({{"index", all[i].index},
                    {"wave", wave_names(all[i])},
                    {"order", all[i].naming_wave().engine_order},
                    {"between", {all[i].speed_low * rpm_per_rad_s, all[i].speed_high * rpm_per_rad_s}},
                    {"slack", all[i].amplitude_slack()},
                    {"open", open_of(budgets, all[i])},
                    {"goodman", goodman_of(fields.peaks[i])},
                    {"stress", stress_of(fields.peaks[i])},
                    {"vibration", fields.peaks[i] ? json(fields.peaks[i]->body.vibration * mpa_per_pa) : json()},
                    {"over_cycle", fields.peaks[i] && fields.peaks[i]->cycle}});
  return list;
}

json avoid_of(const std::vector<AvoidedBand>& bands) {
  json list = json::array();
  for (const AvoidedBand& band : bands)
    list.push_back({{"low", band.speeds.low * rpm_per_rad_s},
                    {"high", band.speeds.high * rpm_per_rad_s},
                    {"concern", name_of(band.concern)},
                    {"reason", reason_of(band)},
                    {"grade", static_cast<int>(band.concern)}});
  return list;
}

/// [MPa] What Goodman's rule compares with, and the mean stress of the worst cycle; null if the case gives no
/// strengths.
json strength_of(const FieldResults& fields) {
  const StressCycle* const worst = fields.worst_cycle();
  if (worst == nullptr) return {};
  const auto& strength = *worst->strength;
  return {{"endurance", strength.endurance * mpa_per_pa},
          {"ultimate", strength.ultimate * mpa_per_pa},
          {"yield", strength.yield ? json(*strength.yield * mpa_per_pa) : json()},
          {"mean", worst->mean * mpa_per_pa},
          {"allowed", allowed_alternating(*worst) * mpa_per_pa}};
}

/// [rpm] of the crossings that the linear rules list.
json speeds_of(const SpeedFrame& frame, const std::vector<Crossing>& crossings) {
  json speeds = json::array();
  for (const Crossing& crossing : drawn_crossings(frame, crossings)) speeds.push_back(crossing.speed * rpm_per_rad_s);
  return speeds;
}

/// [Hz] The drawn families of every nodal diameter over the speeds.
json add_modes(PackedArrays& arrays, const SpeedFrame& frame) {
  json list = json::array();
  for (int n = 0; n < frame.nodal_diameters(); ++n)
    for (int family = 0; family < frame.families_at(n); ++family) {
      Eigen::VectorXd curve(frame.speeds.size());
      for (Eigen::Index i = 0; i < curve.size(); ++i)
        curve[i] = frame.curves.frequency(n, family, frame.speeds[i] / rpm_per_rad_s);
      arrays.add("mode/" + std::to_string(list.size()), curve);
      list.push_back({{"nodal_diameter", n}, {"family", family + 1}});
    }
  return list;
}

/// [deg] Where both ends of the main blade's tip line of sector 0 stand in the rotor.
json tip_angles(const ContactLine& contact) {
  const auto degrees = [&](int node) { return contact.position(node, 1) / radians_per_degree; };
  return {{"leading", degrees(0)}, {"trailing", degrees(contact.trailing_edge())}};
}

json axes_of(const Study& study, const SpeedFrame& frame) {
  return {{"speed", {frame.axis.low, frame.axis.high}},
          {"frequency", map_frequency_high(frame)},
          {"amplitude", study.amplitudes.largest.maxCoeff() * mm_per_m},
          {"map", map_frame(frame, study.waves, study.parameters).amplitude.high},
          {"decades", study.parameters.amplitude_decades},
          {"engine_orders", study.parameters.engine_order_max}};
}

/// The parts and the total of a map [mm], speed after speed, and where those of each speed begin.
json add_map(PackedArrays& arrays, const InteractionMap& map, const std::string& place) {
  json speeds = json::array();
  Eigen::Index lines = 0;
  for (const MapColumn& column : map.columns) {
    speeds.push_back({{"rpm", column.speed * rpm_per_rad_s},
                      {"first", lines},
                      {"lines", column.total.size()},
                      {"revolutions", column.spectrum.revolutions}});
    lines += column.total.size();
  }
  Eigen::MatrixXd parts(lines, map.columns.front().parts.cols());
  for (std::size_t i = 0; i < map.columns.size(); ++i)
    parts.middleRows(speeds[i]["first"], map.columns[i].parts.rows()) = mm_per_m * map.columns[i].parts;
  arrays.add(place + "total", parts.rowwise().sum());
  for (Eigen::Index n = 0; n < parts.cols(); ++n) arrays.add(place + std::to_string(n), parts.col(n));
  return speeds;
}

/// The other reports, which the page draws beside this one.
json add_others(PackedArrays& arrays, const std::vector<ReportNumbers>& others) {
  json list = json::array();
  for (const ReportNumbers& other : others) {
    const std::string place = "other/" + std::to_string(list.size()) + "/";
    arrays.add(place + "speed", other.speed);
    arrays.add(place + "largest", other.amplitude);
    list.push_back({{"name", other.name},
                    {"leading", add_map(arrays, other.leading_map, place + "leading/")},
                    {"trailing", add_map(arrays, other.trailing_map, place + "trailing/")}});
  }
  return list;
}

}  // namespace

std::string speed_data(const Study& study, const FieldResults& fields, const std::vector<ReportNumbers>& others) {
  const SpeedFrame frame = speed_frame(study);
  PackedArrays arrays;
  const Eigen::VectorXd utilisation = utilisation_over_speed(study, fields);
  json speeds = json::array(), failed = json::array();
  for (Eigen::Index i = 0; i < study.amplitudes.largest.size(); ++i)
    speeds.push_back(add_speed(arrays, study, fields, utilisation, frame, i));
  for (const SpeedResponse& speed : study.failed) failed.push_back(speed.speed * rpm_per_rad_s);
  return arrays.packed({{"sectors", study.model.sector_count},
                        {"held", study.response.scene.independent_sectors},
                        {"lobes", study.response.scene.lobes},
                        {"component", key_of(study.parameters.component)},
                        {"tip_angle", tip_angles(study.model.contact)},
                        {"edge", study.parameters.edge == TipEdge::leading ? "leading" : "trailing"},
                        {"shown", study.shown},
                        {"speeds", std::move(speeds)},
                        {"failed", std::move(failed)},
                        {"others", add_others(arrays, others)},
                        {"critical", critical_of(study, fields)},
                        {"predicted",
                         {{"aliased", speeds_of(frame, study.rules.aliased)},
                          {"equation_2", speeds_of(frame, study.rules.equation_2)}}},
                        {"avoid", avoid_of(speeds_to_avoid(study, fields))},
                        {"strength", strength_of(fields)},
                        {"caveat", speeds_caveat(study)},
                        {"operating", {study.parameters.operating_min_rpm, study.parameters.operating_max_rpm}},
                        {"modes", add_modes(arrays, frame)},
                        {"axes", axes_of(study, frame)}});
}

}  // namespace tiprub::postprocess
