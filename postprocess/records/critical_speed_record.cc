// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/study_records.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <string_view>

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

struct PeakRow {
  const Study& study;
  const CriticalSpeed& critical;
  const WaveLabel& wave;  ///< that it is called after
  const SpeedResponse& response;
  const std::optional<FieldPeak>& stress;
  std::string outside;  ///< of validity
};

using PeakRows = std::vector<PeakRow>;
using PeakColumns = std::vector<Column<PeakRow>>;

PeakRows peaks_of(const Study& study, const FieldResults& fields) {
  PeakRows peaks;
  for (std::size_t i = 0; i < study.critical.size(); ++i) {
    const CriticalSpeed& critical = study.critical[i];
    peaks.push_back({study, critical, critical.naming_wave(), study.speed_at(critical.index), fields.peaks[i],
                     outside_validity(study, critical.index, fields.peaks[i])});
  }
  return peaks;
}

int places(const PeakRow& peak, const ContactMap& edge) {
  return edge.clusters[peak.critical.index];
}

std::string signed_percent(double value) {
  return (value >= 0 ? "+" : "") + fixed(percent * value, 1);
}

/// A column from full fields; empty without them.
Column<PeakRow> stress_column(const char* name, const std::function<Cell(const FieldPeak&)>& cell) {
  return {name, [cell](const PeakRow& peak) { return peak.stress ? cell(*peak.stress) : Cell(std::string()); }};
}

/// A column from a whole cycle; empty without one.
Column<PeakRow> cycle_column(const char* name, const std::function<Cell(const StressCycle&)>& cell) {
  return stress_column(
      name, [cell](const FieldPeak& peak) { return peak.cycle ? cell(*peak.cycle) : Cell(std::string()); });
}

/// "EO 8 ND -2 0.053 mm; EO 16 ND -4 0.052 mm", the first `count` of them.
std::string other_waves(const CriticalSpeed& critical, std::size_t count) {
  constexpr int digits = 3;
  const std::vector<WaveLabel> waves = critical.waves_beside();
  std::string text;
  for (std::size_t i = 0; i < std::min(count, waves.size()); ++i)
    text +=
        (i > 0 ? "; " : "") + wave_name(waves[i]) + " " + significant(waves[i].amplitude * mm_per_m, digits) + " mm";
  return text;
}

/// "-9 +12": how far below and above are the speeds at which the response has clearly fallen [rpm].
std::string located(const CriticalSpeed& critical) {
  return "-" + fixed((critical.speed - critical.speed_low) * rpm_per_rad_s, 0) + " +" +
         fixed((critical.speed_high - critical.speed) * rpm_per_rad_s, 0);
}

/// "19502 .. 19546" [rpm]
std::string interval(const CriticalSpeed& critical) {
  return fixed(critical.speed_low * rpm_per_rad_s, 0) + " .. " + fixed(critical.speed_high * rpm_per_rad_s, 0);
}

/// Whether a motion from another start clearly differs from the speed's own.
bool is_another(const OtherStart& start, const SpeedResponse& response) {
  constexpr double another = 0.02;  // of the motion's norm
  if (!start.failure.empty()) return false;
  if (!repeats(start.motion) && !repeats(response.motion)) return start.difference > clear_irregular_difference;
  return start.difference > another || std::abs(start.amplitude - response.amplitude) > another * response.amplitude;
}

/// "up: modulated 0.045 mm; ...": motions from other starts that clearly differ from the speed's own; "none found",
/// or empty if no other start was tried. The whole wheel has columns of its own.
std::string other_motions(const SpeedResponse& response) {
  const std::string text = listed(response.other_starts, "; ", [&](const OtherStart& start) {
    if (&start == whole_wheel(response) || !is_another(start, response)) return std::string();
    return text_of(name_of(start.start), ": ", motion_text(start.motion, start.period_beats), " ",
                   significant(start.amplitude * mm_per_m, 3), " mm");
  });
  return text.empty() && !response.other_starts.empty() ? "none found" : text;
}

/// "symmetric, unstable (periodic); whole wheel: modulated, |u| 2.91 / 3.30 / 4.12 mm"
std::string motion_and_what_is_seen(const SpeedResponse& speed) {
  const std::string seen = whole_wheel_text(speed);
  return motion_text(speed) + (seen.empty() ? "" : "; whole wheel: " + seen + " mm");
}

/// [mm]
Column<PeakRow> blade_column(const char* name, double BladeExcursions::*of_blades) {
  return {name, [of_blades](const PeakRow& peak) {
            const OtherStart* whole = whole_wheel(peak.response);
            return whole ? Cell((*whole->blades).*of_blades * mm_per_m) : Cell(std::string());
          }};
}

/// [m] The motion of the tip in all directions together.
double excursion(const PeakRow& peak) {
  return peak.study.excursion_at(peak.critical.index);
}

PeakColumns amplitude_columns() {
  return {{"speed [rpm]", [](const PeakRow& peak) { return peak.critical.speed * rpm_per_rad_s; }},
          {"speed [rad/s]", [](const PeakRow& peak) { return peak.critical.speed; }},
          {"amplitude [mm]", [](const PeakRow& peak) { return peak.critical.amplitude * mm_per_m; }},
          {"tip |u| [mm]", [](const PeakRow& peak) { return excursion(peak) * mm_per_m; }},
          {"speed low [rpm]", [](const PeakRow& peak) { return peak.critical.speed_low * rpm_per_rad_s; }},
          {"speed high [rpm]", [](const PeakRow& peak) { return peak.critical.speed_high * rpm_per_rad_s; }},
          {"amplitude low [mm]", [](const PeakRow& peak) { return peak.critical.amplitude_low * mm_per_m; }},
          {"amplitude high [mm]", [](const PeakRow& peak) { return peak.critical.amplitude_high * mm_per_m; }},
          {"speeds beside it over half-width [1]",
           [](const PeakRow& peak) { return optional_cell(peak.critical.spacing_over_half_width()); }},
          {"prominence [mm]", [](const PeakRow& peak) { return peak.critical.prominence * mm_per_m; }},
          {"contact node", [](const PeakRow& peak) { return peak.critical.node; }}};
}

PeakColumns wave_columns() {
  return {
      {"family", [](const PeakRow& peak) { return peak.wave.family + 1; }},
      {"nodal diameter", [](const PeakRow& peak) { return std::abs(peak.wave.signed_nodal_diameter); }},
      {"signed nodal diameter", [](const PeakRow& peak) { return peak.wave.signed_nodal_diameter; }},
      {"engine order", [](const PeakRow& peak) { return peak.wave.engine_order; }},
      {"wave", [](const PeakRow& peak) { return wave_names(peak.critical); }},
      {"direction", [](const PeakRow& peak) { return name_of(peak.wave.direction); }},
      {"wave amplitude [mm]", [](const PeakRow& peak) { return peak.wave.amplitude * mm_per_m; }},
      {"natural frequency [Hz]", [](const PeakRow& peak) { return peak.wave.natural_frequency; }},
      {"detuning [%]", [](const PeakRow& peak) { return percent * peak.wave.detuning; }},
      {"wave share [1]", [](const PeakRow& peak) { return peak.critical.wave_share(); }},
      {"largest wave", [](const PeakRow& peak) { return wave_name(peak.critical.largest); }},
      {"largest wave amplitude [mm]", [](const PeakRow& peak) { return peak.critical.largest.amplitude * mm_per_m; }},
      {"other waves",
       [](const PeakRow& peak) { return other_waves(peak.critical, peak.critical.waves_beside().size()); }},
  };
}

PeakColumns contact_columns() {
  return {
      {"contact areas leading edge", [](const PeakRow& peak) { return places(peak, peak.study.contact.leading); }},
      {"contact areas trailing edge", [](const PeakRow& peak) { return places(peak, peak.study.contact.trailing); }}};
}

PeakColumns stress_columns() {
  return {
      stress_column("von Mises, vibration [MPa]",
                    [](const FieldPeak& peak) { return peak.body.vibration * mpa_per_pa; }),
      stress_column("von Mises, spin [MPa]", [](const FieldPeak& peak) { return peak.body.spin * mpa_per_pa; }),
      stress_column("von Mises, both [MPa]", [](const FieldPeak& peak) { return peak.body.both * mpa_per_pa; }),
      stress_column("where the vibration's is largest", [](const FieldPeak& peak) { return peak.where; }),
      stress_column("part with the largest vibration stress", [](const FieldPeak& peak) { return peak.part; }),
      stress_column("radius of the largest vibration stress [mm]",
                    [](const FieldPeak& peak) { return peak.place[0] * mm_per_m; }),
      stress_column("a node moves by up to [mm]", [](const FieldPeak& peak) { return peak.displacement * mm_per_m; }),
      stress_column("samples of the cycle", [](const FieldPeak& peak) { return peak.samples; }),
      stress_column("in the tip patch, vibration [MPa]",
                    [](const FieldPeak& peak) { return peak.tip_patch.vibration * mpa_per_pa; }),
      stress_column("at the clamp's rim, vibration [MPa]",
                    [](const FieldPeak& peak) { return peak.clamp_rim.vibration * mpa_per_pa; }),
      stress_column("at the clamp's rim, both [MPa]",
                    [](const FieldPeak& peak) { return peak.clamp_rim.both * mpa_per_pa; })};
}

PeakColumns cycle_columns() {
  return {
      cycle_column("alternating [MPa]", [](const StressCycle& cycle) { return cycle.alternating * mpa_per_pa; }),
      cycle_column("mean [MPa]", [](const StressCycle& cycle) { return cycle.mean * mpa_per_pa; }),
      cycle_column("where these are", [](const StressCycle& cycle) { return cycle.where; }),
      cycle_column("Goodman utilisation [1]", [](const StressCycle& cycle) { return optional_cell(cycle.goodman); }),
      stress_column("both over yield [1]", [](const FieldPeak& peak) { return optional_cell(peak.yield_share); })};
}

PeakColumns friction_columns() {
  constexpr double kw_per_w = 1e-3;
  return {{"rub power, mean [kW]",
           [](const PeakRow& peak) { return optional_cell(peak.response.friction.rub_power_mean, kw_per_w); }},
          {"rub power, largest [kW]",
           [](const PeakRow& peak) { return optional_cell(peak.response.friction.rub_power_largest, kw_per_w); }}};
}

PeakColumns validity_columns() {
  return {{"outside validity", [](const PeakRow& peak) { return peak.outside; }}};
}

PeakColumns prediction_columns() {
  return {{"motion", [](const PeakRow& peak) { return motion_text(peak.response); }},
          {"motions from other starts", [](const PeakRow& peak) { return other_motions(peak.response); }},
          {"motion of the whole wheel",
           [](const PeakRow& peak) {
             const OtherStart* whole = whole_wheel(peak.response);
             return whole ? motion_text(whole->motion, whole->period_beats) : std::string();
           }},
          blade_column("tip |u| of the whole wheel, least of the blades [mm]", &BladeExcursions::least),
          blade_column("tip |u| of the whole wheel, median of the blades [mm]", &BladeExcursions::median),
          blade_column("tip |u| of the whole wheel, largest of the blades [mm]", &BladeExcursions::largest),
          {"predicted by eq. 2", [](const PeakRow& peak) { return yes_or_no(peak.critical.by_equation_2); }},
          {"predicted with aliasing", [](const PeakRow& peak) { return yes_or_no(peak.critical.by_aliasing); }}};
}

/// "eq. 2, aliasing", or "no rule".
std::string predicting_rules(const CriticalSpeed& critical) {
  if (!critical.by_equation_2) return critical.by_aliasing ? "aliasing" : "no rule";
  return critical.by_aliasing ? "eq. 2, aliasing" : "eq. 2";
}

PeakColumns rounded_columns() {
  constexpr std::size_t shown_others = 2;
  return {{"speed [rpm]", [](const PeakRow& peak) { return fixed(peak.critical.speed * rpm_per_rad_s, 0); }},
          {"located [rpm]", [](const PeakRow& peak) { return located(peak.critical); }},
          {"amplitude [mm]", [](const PeakRow& peak) { return fixed(peak.critical.amplitude * mm_per_m, 4); }},
          {"tip |u| [mm]", [](const PeakRow& peak) { return fixed(excursion(peak) * mm_per_m, 3); }},
          {"within [%]", [](const PeakRow& peak) { return fixed(percent * peak.critical.amplitude_slack(), 1); }},
          {"node", [](const PeakRow& peak) { return std::to_string(peak.critical.node); }},
          {"family", [](const PeakRow& peak) { return std::to_string(peak.wave.family + 1); }},
          {"wave", [](const PeakRow& peak) { return wave_names(peak.critical); }},
          {"runs", [](const PeakRow& peak) { return name_of(peak.wave.direction); }},
          {"share [%]", [](const PeakRow& peak) { return fixed(percent * peak.critical.wave_share(), 0); }},
          {"detuning [%]", [](const PeakRow& peak) { return signed_percent(peak.wave.detuning); }},
          {"other waves", [](const PeakRow& peak) { return other_waves(peak.critical, shown_others); }},
          {"areas LE/TE",
           [](const PeakRow& peak) {
             return std::to_string(places(peak, peak.study.contact.leading)) + "/" +
                    std::to_string(places(peak, peak.study.contact.trailing));
           }},
          {"motion", [](const PeakRow& peak) { return motion_and_what_is_seen(peak.response); }}};
}

std::string rounded_mpa(double stress) {
  return fixed(stress * mpa_per_pa, 1);
}

PeakColumns rounded_stress_columns() {
  return {stress_column(
              "vibration [MPa]",
              [](const FieldPeak& peak) { return (peak.cycle ? "" : "> ") + rounded_mpa(peak.body.vibration); }),
          stress_column("spin [MPa]", [](const FieldPeak& peak) { return rounded_mpa(peak.body.spin); }),
          stress_column("both [MPa]", [](const FieldPeak& peak) { return rounded_mpa(peak.body.both); }),
          stress_column("stressed most", [](const FieldPeak& peak) { return peak.where; }),
          stress_column("a node moves by up to [mm]",
                        [](const FieldPeak& peak) { return fixed(peak.displacement * mm_per_m, 2); })};
}

PeakColumns rounded_cycle_columns() {
  return {cycle_column("alternating [MPa]", [](const StressCycle& cycle) { return rounded_mpa(cycle.alternating); }),
          cycle_column("mean [MPa]", [](const StressCycle& cycle) { return rounded_mpa(cycle.mean); }),
          cycle_column("Goodman", [](const StressCycle& cycle) {
            return cycle.goodman ? fixed(*cycle.goodman, 2) : std::string();
          })};
}

PeakColumns shown_stress_columns(const FieldResults& fields) {
  PeakColumns columns;
  if (fields.has_stress()) columns = rounded_stress_columns();
  if (fields.has_cycles()) columns = joined<Column<PeakRow>>({columns, rounded_cycle_columns()});
  return columns;
}

}  // namespace

Table critical_speed_record(const Study& study, const FieldResults& fields) {
  return table_of(
      joined<Column<PeakRow>>({amplitude_columns(), wave_columns(), contact_columns(), stress_columns(),
                               cycle_columns(), prediction_columns(), friction_columns(), validity_columns()}),
      peaks_of(study, fields));
}

Table critical_speed_overview(const Study& study, const FieldResults& fields) {
  // A terminal has room for so many columns.
  constexpr auto shown =
      std::to_array<std::string_view>({"speed [rpm]", "located [rpm]", "tip |u| [mm]", "within [%]", "wave",
                                       "share [%]", "vibration [MPa]", "Goodman", "outside validity"});
  PeakColumns columns =
      joined<Column<PeakRow>>({rounded_columns(), shown_stress_columns(fields), validity_columns()});
  std::erase_if(columns, [&](const auto& column) { return std::ranges::find(shown, column.name) == shown.end(); });
  for (auto& column : columns)
    if (column.name == std::string_view("wave"))
      column.cell = [](const PeakRow& peak) { return peak.critical.is_mixed() ? "mixed" : wave_name(peak.wave); };
  columns.push_back({"motion", [](const PeakRow& peak) { return motion_text(peak.response); }});
  return table_of(columns, peaks_of(study, fields));
}

Table critical_speed_motions(const Study& study) {
  // A page has room for words, and for the ends of the interval in place of the distances to them.
  const std::map<std::string_view, const char*> words = {{"located [rpm]", "peak lies between [rpm]"},
                                                         {"within [%]", "amplitude \xC2\xB1 [%]"},
                                                         {"runs", "direction"},
                                                         {"areas LE/TE", "places rubbed, leading / trailing edge"}};
  PeakColumns columns = rounded_columns();
  columns.push_back({"predicted by", [](const PeakRow& peak) { return predicting_rules(peak.critical); }});
  columns[1].cell = [](const PeakRow& peak) { return interval(peak.critical); };
  for (auto& column : columns)
    if (const auto found = words.find(column.name); found != words.end()) column.name = found->second;
  return table_of(columns, peaks_of(study, field_results(std::nullopt, study.critical)));
}

Table critical_speed_stresses(const Study& study, const FieldResults& fields) {
  return table_of(
      joined<Column<PeakRow>>({{rounded_columns().front()}, shown_stress_columns(fields), validity_columns()}),
      peaks_of(study, fields));
}

}  // namespace tiprub::postprocess
