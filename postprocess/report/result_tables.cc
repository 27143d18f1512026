// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/result_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>

#include "postprocess/figures/figure_style.h"
#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

constexpr double percent = 100.0;

std::string yes_or_no(bool value) {
  return value ? "yes" : "no";
}

std::string order_text(double engine_order) {
  return style::engine_order_name(engine_order).substr(3);
}

std::string signed_percent(double value) {
  return (value >= 0 ? "+" : "") + fixed(percent * value, 1);
}

/// A column's name, and how it is read from what a row is about.
template <class Item>
struct Column {
  const char* name;
  std::function<Cell(const Item&)> cell;
};

template <class Item>
Table table_of(const std::vector<Column<Item>>& columns, const std::vector<Item>& items) {
  Table table;
  for (const Column<Item>& column : columns) table.header.emplace_back(column.name);
  for (const Item& item : items) {
    table.rows.emplace_back();
    for (const Column<Item>& column : columns) table.rows.back().push_back(column.cell(item));
  }
  return table;
}

void sort_by_speed(Table& table) {
  std::stable_sort(table.rows.begin(), table.rows.end(), [](const auto& a, const auto& b) {
    return std::get<double>(a.front()) < std::get<double>(b.front());
  });
}

/// "listed" by a rule, or why eq. 2 leaves a crossing out.
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

std::string symmetry_text(SymmetryVerdict verdict) {
  switch (verdict) {
    case SymmetryVerdict::all_held:
      return "all held";
    case SymmetryVerdict::unchecked:
      return "unchecked";
    case SymmetryVerdict::holds:
      return "holds";
    case SymmetryVerdict::breaking:
      return "breaking";
  }
  return "";
}

/// Empty where simulate didn't look.
Cell cell(const std::optional<double>& value) {
  return value ? Cell(*value) : Cell(std::string());
}

/// [MPa]; empty without full fields.
Cell stress_cell(const CriticalSpeed& critical, double FieldPeak::*stress) {
  return critical.stress ? Cell((*critical.stress).*stress * mpa_per_pa) : Cell(std::string());
}

void append_crossing(Table& table, const Study& study, const Crossing& crossing, const std::string& aliasing) {
  const bool met = std::any_of(study.critical.begin(), study.critical.end(), [&](const CriticalSpeed& critical) {
    return foretells(crossing, critical, study.parameters.prediction_tolerance);
  });
  table.rows.push_back({crossing.speed * rpm_per_rad_s, crossing.frequency, crossing.engine_order,
                        crossing.signed_nodal_diameter,
                        name_of(wave_direction(crossing.signed_nodal_diameter, study.model.sector_count)),
                        crossing.family + 1, equation_2_text(crossing, study.model.sector_count), aliasing,
                        yes_or_no(moves(study, crossing.signed_nodal_diameter)), yes_or_no(met)});
}

}  // namespace

std::string motion_text(MotionClass motion, int period_revolutions) {
  switch (motion) {
    case MotionClass::periodic:
      return "periodic";
    case MotionClass::subharmonic:
      return "subharmonic 1/" + std::to_string(period_revolutions);
    case MotionClass::irregular:
      return "irregular";
  }
  return "";
}

bool has_stress(const Study& study) {
  return std::any_of(study.critical.begin(), study.critical.end(),
                     [](const CriticalSpeed& critical) { return critical.stress.has_value(); });
}

Table critical_speed_record(const Study& study) {
  using Critical = CriticalSpeed;
  return table_of<Critical>(
      {{"speed [rpm]", [](const Critical& at) { return at.speed * rpm_per_rad_s; }},
       {"speed [rad/s]", [](const Critical& at) { return at.speed; }},
       {"amplitude [mm]", [](const Critical& at) { return at.amplitude * mm_per_m; }},
       {"prominence [mm]", [](const Critical& at) { return at.prominence * mm_per_m; }},
       {"contact node", [](const Critical& at) { return at.node; }},
       {"family", [](const Critical& at) { return at.rising.family + 1; }},
       {"nodal diameter", [](const Critical& at) { return std::abs(at.rising.signed_nodal_diameter); }},
       {"signed nodal diameter", [](const Critical& at) { return at.rising.signed_nodal_diameter; }},
       {"engine order", [](const Critical& at) { return at.rising.engine_order; }},
       {"wave", [](const Critical& at) { return name_of(at.rising.direction); }},
       {"wave amplitude [mm]", [](const Critical& at) { return at.rising.amplitude * mm_per_m; }},
       {"natural frequency [Hz]", [](const Critical& at) { return at.rising.natural_frequency; }},
       {"detuning [%]", [](const Critical& at) { return percent * at.rising.detuning; }},
       {"largest engine order", [](const Critical& at) { return at.largest.engine_order; }},
       {"largest signed nodal diameter", [](const Critical& at) { return at.largest.signed_nodal_diameter; }},
       {"largest wave amplitude [mm]", [](const Critical& at) { return at.largest.amplitude * mm_per_m; }},
       {"contact areas leading edge", [](const Critical& at) { return at.leading_edge_areas; }},
       {"contact areas trailing edge", [](const Critical& at) { return at.trailing_edge_areas; }},
       {"von Mises, vibration [MPa]", [](const Critical& at) { return stress_cell(at, &FieldPeak::vibration); }},
       {"von Mises, spin [MPa]", [](const Critical& at) { return stress_cell(at, &FieldPeak::spin); }},
       {"von Mises, both [MPa]", [](const Critical& at) { return stress_cell(at, &FieldPeak::both); }},
       {"vibration stresses most", [](const Critical& at) { return at.stress ? at.stress->part : std::string(); }},
       {"at radius [mm]",
        [](const Critical& at) { return at.stress ? Cell(at.stress->place[0] * mm_per_m) : Cell(std::string()); }},
       {"motion", [](const Critical& at) { return motion_text(at.motion, at.period_revolutions); }},
       {"foretold by eq. 2", [](const Critical& at) { return yes_or_no(at.by_equation_2); }},
       {"foretold with aliasing", [](const Critical& at) { return yes_or_no(at.by_aliasing); }}},
      study.critical);
}

Table critical_speed_summary(const Study& study) {
  Table table{{"speed [rpm]", "amplitude [mm]", "family", "nodal diameter", "engine order", "wave", "detuning [%]",
               "largest wave", "areas LE/TE", "motion", "eq. 2", "aliasing"},
              {}};
  const bool stressed = has_stress(study);
  if (stressed) table.header.insert(table.header.end(), {"vibration [MPa]", "spin [MPa]", "both [MPa]"});
  for (const CriticalSpeed& critical : study.critical) {
    const WaveLabel& wave = critical.rising;
    table.rows.push_back(
        {fixed(critical.speed * rpm_per_rad_s, 0), fixed(critical.amplitude * mm_per_m, 4),
         std::to_string(wave.family + 1), std::to_string(std::abs(wave.signed_nodal_diameter)),
         order_text(wave.engine_order), name_of(wave.direction), signed_percent(wave.detuning),
         style::engine_order_name(critical.largest.engine_order) + ", ND " +
             std::to_string(critical.largest.signed_nodal_diameter),
         std::to_string(critical.leading_edge_areas) + "/" + std::to_string(critical.trailing_edge_areas),
         motion_text(critical.motion, critical.period_revolutions), yes_or_no(critical.by_equation_2),
         yes_or_no(critical.by_aliasing)});
    if (!stressed) continue;
    for (double FieldPeak::*const stress : {&FieldPeak::vibration, &FieldPeak::spin, &FieldPeak::both})
      table.rows.back().emplace_back(critical.stress ? fixed((*critical.stress).*stress * mpa_per_pa, 1) : "");
  }
  return table;
}

Table linear_criterion_record(const Study& study) {
  Table table{{"speed [rpm]", "frequency [Hz]", "engine order", "signed nodal diameter", "wave", "family", "eq. 2",
               "with aliasing", "nodal diameter can move", "critical speed found"},
              {}};
  const int lobes = study.response.scene.lobes;
  for (const Crossing& crossing : study.aliased) append_crossing(table, study, crossing, "listed");
  for (const Crossing& crossing : study.equation_2)
    if (lobes < 1 || crossing.engine_order % lobes != 0 ||
        crossing.engine_order > study.parameters.engine_order_max)  // else it is listed above
      append_crossing(table, study, crossing, "excluded: not driven by this casing");
  sort_by_speed(table);
  return table;
}

Table speed_record(const Study& study) {
  using Speed = SpeedResponse;
  const auto place = [&](const Speed& at) { return &at - study.response.speeds.data(); };
  Table table = table_of<Speed>(
      {{"speed [rpm]", [](const Speed& at) { return at.speed * rpm_per_rad_s; }},
       {"amplitude [mm]", [&](const Speed& at) { return study.amplitudes.largest[place(at)] * mm_per_m; }},
       {"motion", [](const Speed& at) { return motion_text(at.motion, at.period_revolutions); }},
       {"revolutions", [](const Speed& at) { return at.revolutions; }},
       {"recorded", [](const Speed& at) { return at.recorded_revolutions; }},
       {"change", [](const Speed& at) { return at.change; }},
       {"change rate", [](const Speed& at) { return at.change_rate; }},
       {"energy closing error", [](const Speed& at) { return at.energy.closing_error; }},
       {"steps per revolution", [](const Speed& at) { return at.steps_per_revolution; }},
       {"step ratio", [](const Speed& at) { return at.step_ratio; }},
       {"contact steps", [](const Speed& at) { return static_cast<double>(at.contact_steps); }},
       {"tension steps", [](const Speed& at) { return static_cast<double>(at.tension_steps); }},
       {"fallbacks", [](const Speed& at) { return static_cast<double>(at.solver_fallbacks); }},
       {"largest penetration [mm]", [](const Speed& at) { return at.largest_penetration * mm_per_m; }},
       {"smallest multiplier [N]", [](const Speed& at) { return at.smallest_multiplier; }},
       {"leftover steps", [](const Speed& at) { return static_cast<double>(at.audit.leftover_steps); }},
       {"pulling share of force", [](const Speed& at) { return at.audit.tension_share; }},
       {"half the step changes", [](const Speed& at) { return cell(at.audit.halving_difference); }},
       {"symmetry", [](const Speed& at) { return symmetry_text(at.audit.symmetry); }},
       {"growth left out", [](const Speed& at) { return cell(at.audit.excluded_growth); }},
       {"from rest differs", [](const Speed& at) { return cell(at.audit.rest_difference); }},
       {"off the engine orders [%]",
        [&](const Speed& at) {
          return percent * subharmonic_share(study.map.columns[static_cast<std::size_t>(place(at))].spectrum);
        }},
       {"areas LE", [&](const Speed& at) { return study.leading_edge.clusters[place(at)]; }},
       {"areas TE", [&](const Speed& at) { return study.trailing_edge.clusters[place(at)]; }},
       {"contrast LE", [&](const Speed& at) { return study.leading_edge.contrast[place(at)]; }},
       {"contrast TE", [&](const Speed& at) { return study.trailing_edge.contrast[place(at)]; }},
       {"failure", [](const Speed&) { return std::string(); }}},
      study.response.speeds);
  for (const SpeedResponse& at : study.failed) {
    std::vector<Cell> row(table.header.size(), std::string());
    row.front() = at.speed * rpm_per_rad_s;
    row.back() = at.failure;
    table.rows.push_back(std::move(row));
  }
  sort_by_speed(table);
  return table;
}

Table sweep_record(const Study& study) {
  Table table{{"speed [rpm]", "from rest [mm]", "up [mm]", "down [mm]", "motion from rest", "motion up",
               "motion down", "up from rest [1]", "down from rest [1]", "differ"},
              {}};
  for (const SweepComparison& at : study.sweeps) {
    const SpeedResponse& here = study.response.speeds[static_cast<std::size_t>(at.index)];
    const auto amplitude = [](const std::optional<SweptSpeed>& swept) {
      return swept ? Cell(swept->amplitude * mm_per_m) : Cell(std::string());
    };
    const auto motion = [](const std::optional<SweptSpeed>& swept) {
      return swept ? motion_text(swept->motion, swept->period_revolutions) : std::string();
    };
    const auto difference = [](const std::optional<SweptSpeed>& swept) {
      return swept ? Cell(swept->difference) : Cell(std::string());
    };
    table.rows.push_back({here.speed * rpm_per_rad_s, study.amplitudes.largest[at.index] * mm_per_m, amplitude(at.up),
                          amplitude(at.down), motion_text(here.motion, here.period_revolutions), motion(at.up),
                          motion(at.down), difference(at.up), difference(at.down), yes_or_no(at.differs())});
  }
  return table;
}

Table drift_record(const Study& study) {
  Table table{{"edge", "slope [s]", "intercept [rad]", "R^2", "tip length [m]", "tip length over slope [m/s]"}, {}};
  const Eigen::VectorXd& arc = study.model.contact.arc_length;
  const auto add = [&](const char* edge, const ContactDrift& drift) {
    table.rows.push_back({std::string(edge), drift.slope, drift.intercept, drift.determination,
                          arc[arc.size() - 1] - arc[0], drift.implied_wave_speed});
  };
  add("leading", study.leading_drift);
  add("trailing", study.trailing_drift);
  return table;
}

}  // namespace tiprub
