// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/study_records.h"

#include <algorithm>
#include <cstdlib>
#include <numbers>

#include "postprocess/analysis/other_motions.h"
#include "postprocess/fields/field_study.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

struct SpeedRow {
  const SpeedResponse& response;
  double amplitude;  ///< [m]
  const TravellingSpectrum& spectrum;
  const ContactMaps& contact;
  const GapTerms& gap;
  Eigen::Index index;                 ///< in the response's speeds
  std::optional<double> stress;       ///< [Pa] FieldResults::over_speed
  std::optional<double> utilisation;  ///< [1] utilisation_over_speed()
};

using SpeedColumns = std::vector<Column<SpeedRow>>;

Cell count(std::int64_t value) {
  return static_cast<double>(value);
}

SpeedColumns motion_columns() {
  return {{"speed [rpm]", [](const SpeedRow& speed) { return speed.response.speed * rpm_per_rad_s; }},
          {"amplitude [mm]", [](const SpeedRow& speed) { return speed.amplitude * mm_per_m; }},
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

SpeedColumns estimated_stress_columns() {
  return {
      {"von Mises, vibration, estimated [MPa]",
       [](const SpeedRow& speed) { return optional_cell(speed.stress, mpa_per_pa); }},
      {"Goodman utilisation, estimated [1]", [](const SpeedRow& speed) { return optional_cell(speed.utilisation); }}};
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
  return {{"steps left in penetration", [](const SpeedRow& speed) { return count(speed.response.leftover_steps); }},
          {"tensile share of contact force", [](const SpeedRow& speed) { return speed.response.tension_share; }},
          {"change by the last halving of the step",
           [](const SpeedRow& speed) { return optional_cell(speed.response.audit.halving_difference); }},
          {"symmetry", [](const SpeedRow& speed) { return name_of(speed.response.audit.symmetry); }},
          {"growth per revolution of nodal diameters left out",
           [](const SpeedRow& speed) { return optional_cell(speed.response.audit.excluded_growth); }},
          {"difference from rest",
           [](const SpeedRow& speed) { return optional_cell(speed.response.audit.rest_difference); }}};
}

SpeedColumns map_columns() {
  return {{"off the engine orders [%]",
           [](const SpeedRow& speed) { return percent * subharmonic_share(speed.spectrum); }},
          {"contact areas LE", [](const SpeedRow& speed) { return speed.contact.leading.clusters[speed.index]; }},
          {"contact areas TE", [](const SpeedRow& speed) { return speed.contact.trailing.clusters[speed.index]; }},
          {"contact contrast LE", [](const SpeedRow& speed) { return speed.contact.leading.contrast[speed.index]; }},
          {"contact contrast TE", [](const SpeedRow& speed) { return speed.contact.trailing.contrast[speed.index]; }},
          {"leading after trailing edge [s]",
           [](const SpeedRow& speed) { return number_if_any(speed.contact.lag.time[speed.index]); }},
          {"likeness of the edges' forces [1]",
           [](const SpeedRow& speed) { return speed.contact.lag.likeness[speed.index]; }},
          {"second order of the gap [mm]", [](const SpeedRow& speed) { return speed.gap.together * mm_per_m; }},
          {"interference [mm]", [](const SpeedRow& speed) { return speed.gap.interference * mm_per_m; }},
          {"outside validity", [](const SpeedRow& speed) { return yes_or_no(speed.gap.beyond()); }},
          {"failure", [](const SpeedRow&) { return std::string(); }}};
}

Cell amplitude_cell(const std::optional<SweptSpeed>& swept) {
  return swept ? Cell(swept->amplitude * mm_per_m) : Cell(std::string());
}

std::string swept_motion(const std::optional<SweptSpeed>& swept) {
  return swept ? motion_text(swept->motion, swept->period_beats) : std::string();
}

Cell difference_cell(const std::optional<SweptSpeed>& swept) {
  return swept ? Cell(swept->difference) : Cell(std::string());
}

/// "listed" by eq. 2, or why it leaves a crossing out.
std::string equation_2_text(const Crossing& crossing, int sector_count) {
  if (crossing.engine_order == crossing.signed_nodal_diameter) return "listed";
  if (wave_direction(crossing.signed_nodal_diameter, sector_count) == WaveDirection::forward)
    return "excluded: forward wave";
  return "excluded: engine order is not the nodal diameter";
}

/// Whether the rule with aliasing (eq. 17) lists a crossing of eq. 2 as well.
bool listed_with_aliasing(const SimulatedScene& scene, const Crossing& crossing) {
  const int lobes = scene.lobes;
  return lobes >= 1 && crossing.engine_order % lobes == 0;
}

void append_crossing(Table& table, const Study& study, const Crossing& crossing, const std::string& aliasing) {
  const int sectors = study.model.sector_count;
  const bool can_move =
      std::ranges::count(study.response.scene.nodal_diameters, std::abs(crossing.signed_nodal_diameter)) > 0;
  const bool met = std::ranges::any_of(study.critical, [&](const CriticalSpeed& critical) {
    return predicts(crossing, critical, study.parameters.prediction_tolerance);
  });
  table.rows.push_back({crossing.speed * rpm_per_rad_s, crossing.frequency, crossing.engine_order,
                        crossing.signed_nodal_diameter,
                        name_of(wave_direction(crossing.signed_nodal_diameter, sectors)), crossing.family + 1,
                        equation_2_text(crossing, sectors), aliasing, yes_or_no(can_move),
                        crossing.amplitude * mm_per_m, yes_or_no(met)});
}

}  // namespace

std::string motion_text(const SpeedResponse& speed) {
  const std::string motion = motion_text(speed.motion, speed.period_beats);
  switch (speed.audit.symmetry) {
    case SymmetryVerdict::breaking:
      return "symmetric, unstable (" + motion + ")";
    case SymmetryVerdict::undecided:
      return "symmetric, stability open (" + motion + ")";
    default:
      return motion;
  }
}

const OtherStart* whole_wheel(const SpeedResponse& speed) {
  const auto whole = std::ranges::find(speed.other_starts, Start::whole_wheel, &OtherStart::start);
  return whole == speed.other_starts.end() || !whole->failure.empty() || !whole->blades ? nullptr : &*whole;
}

std::string whole_wheel_text(const SpeedResponse& speed) {
  const OtherStart* whole = whole_wheel(speed);
  if (!whole) return "";
  const auto mm = [](double motion) { return fixed(motion * mm_per_m, 2); };
  return motion_text(whole->motion, whole->period_beats) + ", |u| " + mm(whole->blades->least) + " / " +
         mm(whole->blades->median) + " / " + mm(whole->blades->largest);
}

Table speed_record(const Study& study, const FieldResults& fields) {
  const Eigen::VectorXd utilisation = utilisation_over_speed(study, fields);
  std::vector<SpeedRow> speeds;
  for (const SpeedResponse& response : study.response.speeds) {
    const auto index = static_cast<Eigen::Index>(speeds.size());
    speeds.push_back({response, study.amplitudes.largest[index], study.waves.first().columns[speeds.size()].spectrum,
                      study.contact, study.gap[speeds.size()], index,
                      fields.over_speed.size() > 0 ? std::optional(fields.over_speed[index]) : std::nullopt,
                      utilisation.size() > 0 ? std::optional(utilisation[index]) : std::nullopt});
  }
  Table table = table_of(joined<Column<SpeedRow>>({motion_columns(), estimated_stress_columns(), step_columns(),
                                                   audit_columns(), map_columns()}),
                         speeds);
  for (const SpeedResponse& failed : study.failed) {
    std::vector<Cell> row(table.header.size(), std::string());
    row.front() = failed.speed * rpm_per_rad_s;
    row.back() = failed.failure;
    table.rows.push_back(std::move(row));
  }
  sort_by_speed(table);
  return table;
}

Table sweep_record(const std::vector<SpeedResponse>& speeds, const TipAmplitudes& amplitudes,
                   const std::vector<SweepComparison>& sweeps) {
  Table table{{"speed [rpm]", "from rest [mm]", "up [mm]", "down [mm]", "motion from rest", "motion up",
               "motion down", "up from rest [1]", "down from rest [1]", "differ"},
              {}};
  for (const SweepComparison& compared : sweeps) {
    const SpeedResponse& from_rest = speeds[static_cast<std::size_t>(compared.index)];
    table.rows.push_back({from_rest.speed * rpm_per_rad_s, amplitudes.largest[compared.index] * mm_per_m,
                          amplitude_cell(compared.up), amplitude_cell(compared.down),
                          motion_text(from_rest.motion, from_rest.period_beats), swept_motion(compared.up),
                          swept_motion(compared.down), difference_cell(compared.up), difference_cell(compared.down),
                          yes_or_no(compared.differs())});
  }
  return table;
}

Table branch_record(const std::vector<OrbitBranch>& branches) {
  Table table{{"branch", "speed [rpm]", "amplitude [mm]", "multiplier [1]", "uncertainty [1]", "angle a map [deg]",
               "attracts", "kind"},
              {}};
  for (std::size_t b = 0; b < branches.size(); ++b) {
    const OrbitBranch& branch = branches[b];
    for (Eigen::Index i = 0; i < branch.speed.size(); ++i)
      table.rows.push_back({static_cast<int>(b), branch.speed[i] * rpm_per_rad_s, branch.amplitude[i] * mm_per_m,
                            branch.multiplier[i], branch.multiplier_uncertainty[i],
                            branch.multiplier_angle[i] * 180 / std::numbers::pi, yes_or_no(branch.attracts(i)),
                            name_of(instability(branch.multiplier_angle[i]))});
  }
  return table;
}

Table drift_record(const ContactMaps& maps, const ContactLine& contact) {
  Table table{{"what", "slope [s]", "intercept [rad]", "R^2", "tip length [m]", "tip length over slope [m/s]",
               "median lag [s]", "lower quartile [s]", "upper quartile [s]"},
              {}};
  const Eigen::VectorXd& arc = contact.arc_length;
  const double length = arc[contact.trailing_edge()] - arc[0];
  const Cell none = std::string();
  const auto add = [&](const char* what, const FittedLine& line, double wave_speed,
                       const std::vector<Cell>& quartiles) {
    table.rows.push_back({std::string(what), number_if_any(line.slope), number_if_any(line.intercept),
                          number_if_any(line.determination), length, number_if_any(wave_speed)});
    table.rows.back().insert(table.rows.back().end(), quartiles.begin(), quartiles.end());
  };
  add("leading edge's middle", maps.leading_drift.line, maps.leading_drift.implied_wave_speed, {none, none, none});
  add("trailing edge's middle", maps.trailing_drift.line, maps.trailing_drift.implied_wave_speed, {none, none, none});
  const EdgeLag& lag = maps.lag;
  add("leading edge's force after the trailing edge's", lag.line,
      lag.line.slope != 0 ? length / std::abs(lag.line.slope) : unknown,
      {number_if_any(lag.median), number_if_any(lag.lower_quartile), number_if_any(lag.upper_quartile)});
  return table;
}

Table linear_criterion_record(const Study& study) {
  Table table{{"speed [rpm]", "frequency [Hz]", "engine order", "signed nodal diameter", "direction", "family",
               "eq. 2", "with aliasing", "nodal diameter can move", "wave amplitude [mm]", "critical speed found"},
              {}};
  for (const Crossing& crossing : study.rules.aliased) append_crossing(table, study, crossing, "listed");
  for (const Crossing& crossing : study.rules.equation_2)
    if (!listed_with_aliasing(study.response.scene, crossing))
      append_crossing(table, study, crossing, "excluded: not driven by this casing");
  sort_by_speed(table);
  return table;
}

Table rule_score_record(const LinearRules& rules) {
  Table table{{"rule", "critical speeds predicted", "missed", "false alarms", "share of amplitude predicted [1]",
               "amplitude of all critical speeds [mm]", "wave amplitude at all false alarms [mm]",
               "largest wave at a false alarm [mm]"},
              {}};
  const auto add = [&](const char* rule, const RuleScore& score) {
    table.rows.push_back({std::string(rule), score.hits, score.misses, score.false_alarms, score.predicted_share,
                          score.summed_amplitudes * mm_per_m, score.summed_alarms * mm_per_m,
                          score.alarm_amplitude * mm_per_m});
  };
  add("eq. 2", rules.equation_2_score);
  add("with aliasing", rules.aliasing_score);
  return table;
}

Table stress_peak_record(const FieldStudy& fields) {
  Table table{{"speed [rpm]", "a node moves by up to [mm]", "von Mises, vibration [MPa]", "von Mises, spin [MPa]",
               "von Mises, both [MPa]", "at sector", "at sample", "r [mm]", "theta [deg]", "z [mm]", "part"},
              {}};
  for (const FieldPeak& peak : fields.peaks)
    table.rows.push_back({peak.speed * rpm_per_rad_s, peak.displacement * mm_per_m, peak.body.vibration * mpa_per_pa,
                          peak.body.spin * mpa_per_pa, peak.body.both * mpa_per_pa, peak.sector, peak.sample,
                          peak.place[0] * mm_per_m, peak.place[1] * 180 / std::numbers::pi, peak.place[2] * mm_per_m,
                          peak.part});
  return table;
}

Table mode_record(const FieldStudy& fields) {
  Table table{{"nodal diameter", "family", "frequency [Hz]", "speed [rpm]"}, {}};
  for (const auto& [part, cells] : fields.sector.parts) table.header.push_back("share of " + part + " [1]");
  for (const ModeShares& mode : fields.modes.shares) {
    table.rows.push_back({mode.nodal_diameter, mode.family + 1, mode.frequency, fields.speed * rpm_per_rad_s});
    for (const auto& [part, share] : mode.share) table.rows.back().emplace_back(share);
  }
  return table;
}

std::string outside_validity(const Study& study, Eigen::Index index, const std::optional<FieldPeak>& stress) {
  const GapTerms& gap = study.gap[static_cast<std::size_t>(index)];
  const bool yields = stress && stress->yield_share.value_or(0) > 1;
  return listed(std::array{gap.beyond() ? gap.in_words() : "",
                           yields ? "stress " + fixed(*stress->yield_share, 2) + " of yield" : ""},
                "; ");
}

std::string validity_in_short(const Study& study, std::size_t critical, const FieldResults& fields) {
  const Eigen::Index index = study.critical[critical].index;
  if (outside_validity(study, index, fields.peaks[critical]).empty()) return "inside";
  const GapTerms& gap = study.gap[static_cast<std::size_t>(index)];
  return "outside: " + (gap.beyond() ? significant(gap.together * mm_per_m, 2) + " / " +
                                           significant(gap.interference * mm_per_m, 2) + " mm"
                                     : std::string("yield"));
}

}  // namespace tiprub::postprocess
