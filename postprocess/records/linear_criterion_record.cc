// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/linear_criterion_record.h"

#include <algorithm>
#include <cstdlib>

#include "postprocess/records/columns.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

/// "listed" by eq. 2, or why it leaves a crossing out.
std::string equation_2_text(const Crossing& crossing, int sector_count) {
  if (crossing.engine_order == crossing.signed_nodal_diameter) return "listed";
  if (wave_direction(crossing.signed_nodal_diameter, sector_count) == WaveDirection::forward)
    return "excluded: forward wave";
  return "excluded: engine order is not the nodal diameter";
}

bool moves(const Study& study, int signed_nodal_diameter) {
  const std::vector<int>& moving = study.response.scene.nodal_diameters;
  return std::find(moving.begin(), moving.end(), std::abs(signed_nodal_diameter)) != moving.end();
}

/// Whether the rule with aliasing (eq. 17) lists a crossing of eq. 2 as well.
bool listed_with_aliasing(const Study& study, const Crossing& crossing) {
  const int lobes = study.response.scene.lobes;
  return lobes >= 1 && crossing.engine_order % lobes == 0;
}

void append_crossing(Table& table, const Study& study, const Crossing& crossing, const std::string& aliasing) {
  const bool met = std::any_of(study.critical.begin(), study.critical.end(), [&](const CriticalSpeed& critical) {
    return predicts(crossing, critical, study.parameters.prediction_tolerance);
  });
  table.rows.push_back(
      {crossing.speed * rpm_per_rad_s, crossing.frequency, crossing.engine_order, crossing.signed_nodal_diameter,
       name_of(wave_direction(crossing.signed_nodal_diameter, study.model.sector_count)), crossing.family + 1,
       equation_2_text(crossing, study.model.sector_count), aliasing,
       yes_or_no(moves(study, crossing.signed_nodal_diameter)), crossing.amplitude * mm_per_m, yes_or_no(met)});
}

}  // namespace

Table linear_criterion_record(const Study& study) {
  Table table{{"speed [rpm]", "frequency [Hz]", "engine order", "signed nodal diameter", "wave", "family", "eq. 2",
               "with aliasing", "nodal diameter can move", "wave amplitude [mm]", "critical speed found"},
              {}};
  for (const Crossing& crossing : study.aliased) append_crossing(table, study, crossing, "listed");
  for (const Crossing& crossing : study.equation_2)
    if (!listed_with_aliasing(study, crossing))
      append_crossing(table, study, crossing, "excluded: not driven by this casing");
  sort_by_speed(table);
  return table;
}

Table rule_score_record(const Study& study) {
  Table table{{"rule", "critical speeds predicted", "missed", "false alarms", "share of amplitude predicted [1]",
               "amplitude of all critical speeds [mm]", "wave amplitude at all false alarms [mm]",
               "largest wave at a false alarm [mm]"},
              {}};
  const auto add = [&](const char* rule, const RuleScore& score) {
    table.rows.push_back({std::string(rule), score.hits, score.misses, score.false_alarms, score.predicted_share,
                          score.summed_amplitudes * mm_per_m, score.summed_alarms * mm_per_m,
                          score.alarm_amplitude * mm_per_m});
  };
  add("eq. 2", study.equation_2_score);
  add("with aliasing", study.aliasing_score);
  return table;
}

}  // namespace tiprub
