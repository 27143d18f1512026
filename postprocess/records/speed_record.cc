// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/speed_record.h"

#include "postprocess/records/columns.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

struct SpeedRow {
  const SpeedResponse& response;
  const Study& study;
  Eigen::Index index;  ///< in the response's speeds
};

using SpeedColumns = std::vector<Column<SpeedRow>>;

std::string symmetry_text(SymmetryVerdict symmetry) {
  switch (symmetry) {
    case SymmetryVerdict::all_held:
      return "all held";
    case SymmetryVerdict::unchecked:
      return "unchecked";
    case SymmetryVerdict::holds:
      return "holds";
    case SymmetryVerdict::undecided:
      return "undecided";
    case SymmetryVerdict::breaking:
      return "breaking";
  }
  return "";
}

Cell count(std::int64_t value) {
  return static_cast<double>(value);
}

SpeedColumns motion_columns() {
  return {{"speed [rpm]", [](const SpeedRow& speed) { return speed.response.speed * rpm_per_rad_s; }},
          {"amplitude [mm]",
           [](const SpeedRow& speed) { return speed.study.amplitudes.largest[speed.index] * mm_per_m; }},
          {"smallest running clearance [mm]",
           [](const SpeedRow& speed) { return speed.response.clearance.minCoeff() * mm_per_m; }},
          {"motion",
           [](const SpeedRow& speed) { return motion_text(speed.response.motion, speed.response.period_beats); }},
          {"revolutions", [](const SpeedRow& speed) { return speed.response.revolutions; }},
          {"recorded revolutions", [](const SpeedRow& speed) { return speed.response.recorded_revolutions; }},
          {"change over the last period", [](const SpeedRow& speed) { return speed.response.change; }},
          {"change factor per revolution", [](const SpeedRow& speed) { return speed.response.change_rate; }},
          {"energy closing error", [](const SpeedRow& speed) { return speed.response.energy.closing_error; }}};
}

SpeedColumns step_columns() {
  return {{"steps per revolution", [](const SpeedRow& speed) { return speed.response.steps_per_revolution; }},
          {"step ratio h omega_max/2", [](const SpeedRow& speed) { return speed.response.step_ratio; }},
          {"contact steps", [](const SpeedRow& speed) { return count(speed.response.contact_steps); }},
          {"tension steps", [](const SpeedRow& speed) { return count(speed.response.tension_steps); }},
          {"contact solver fallbacks", [](const SpeedRow& speed) { return count(speed.response.solver_fallbacks); }},
          {"largest penetration [mm]",
           [](const SpeedRow& speed) { return speed.response.largest_penetration * mm_per_m; }},
          {"smallest multiplier [N]", [](const SpeedRow& speed) { return speed.response.smallest_multiplier; }}};
}

SpeedColumns audit_columns() {
  return {
      {"steps left in penetration", [](const SpeedRow& speed) { return count(speed.response.audit.leftover_steps); }},
      {"tensile share of contact force", [](const SpeedRow& speed) { return speed.response.audit.tension_share; }},
      {"change by the last halving of the step",
       [](const SpeedRow& speed) { return optional_cell(speed.response.audit.halving_difference); }},
      {"symmetry", [](const SpeedRow& speed) { return symmetry_text(speed.response.audit.symmetry); }},
      {"growth per revolution of nodal diameters left out",
       [](const SpeedRow& speed) { return optional_cell(speed.response.audit.excluded_growth); }},
      {"difference from rest",
       [](const SpeedRow& speed) { return optional_cell(speed.response.audit.rest_difference); }}};
}

SpeedColumns map_columns() {
  return {
      {"off the engine orders [%]",
       [](const SpeedRow& speed) {
         return percent * subharmonic_share(speed.study.map.columns[static_cast<std::size_t>(speed.index)].spectrum);
       }},
      {"contact areas LE", [](const SpeedRow& speed) { return speed.study.leading_edge.clusters[speed.index]; }},
      {"contact areas TE", [](const SpeedRow& speed) { return speed.study.trailing_edge.clusters[speed.index]; }},
      {"contact contrast LE", [](const SpeedRow& speed) { return speed.study.leading_edge.contrast[speed.index]; }},
      {"contact contrast TE", [](const SpeedRow& speed) { return speed.study.trailing_edge.contrast[speed.index]; }},
      {"leading after trailing edge [s]",
       [](const SpeedRow& speed) { return number_if_any(speed.study.edge_lag.time[speed.index]); }},
      {"likeness of the edges' forces [1]",
       [](const SpeedRow& speed) { return speed.study.edge_lag.likeness[speed.index]; }},
      {"failure", [](const SpeedRow&) { return std::string(); }}};
}

}  // namespace

Table speed_record(const Study& study) {
  std::vector<SpeedRow> speeds;
  for (const SpeedResponse& response : study.response.speeds)
    speeds.push_back({response, study, static_cast<Eigen::Index>(speeds.size())});
  Table table =
      table_of(joined<SpeedRow>({motion_columns(), step_columns(), audit_columns(), map_columns()}), speeds);
  for (const SpeedResponse& failed : study.failed) {
    std::vector<Cell> row(table.header.size(), std::string());
    row.front() = failed.speed * rpm_per_rad_s;
    row.back() = failed.failure;
    table.rows.push_back(std::move(row));
  }
  sort_by_speed(table);
  return table;
}

}  // namespace tiprub
