// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/result_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "postprocess/figure_style.h"
#include "postprocess/units.h"

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
  Table table{{"speed [rpm]",
               "speed [rad/s]",
               "amplitude [mm]",
               "prominence [mm]",
               "contact node",
               "family",
               "nodal diameter",
               "signed nodal diameter",
               "engine order",
               "wave",
               "wave amplitude [mm]",
               "natural frequency [Hz]",
               "detuning [%]",
               "largest engine order",
               "largest signed nodal diameter",
               "largest wave amplitude [mm]",
               "contact areas leading edge",
               "contact areas trailing edge",
               "von Mises, vibration [MPa]",
               "von Mises, spin [MPa]",
               "von Mises, both [MPa]",
               "vibration stresses most",
               "at radius [mm]",
               "motion",
               "foretold by eq. 2",
               "foretold with aliasing"},
              {}};
  for (const CriticalSpeed& critical : study.critical) {
    const WaveLabel& wave = critical.rising;
    table.rows.push_back({critical.speed * rpm_per_rad_s,
                          critical.speed,
                          critical.amplitude * mm_per_m,
                          critical.prominence * mm_per_m,
                          critical.node,
                          wave.family + 1,
                          std::abs(wave.signed_nodal_diameter),
                          wave.signed_nodal_diameter,
                          wave.engine_order,
                          name_of(wave.direction),
                          wave.amplitude * mm_per_m,
                          wave.natural_frequency,
                          percent * wave.detuning,
                          critical.largest.engine_order,
                          critical.largest.signed_nodal_diameter,
                          critical.largest.amplitude * mm_per_m,
                          critical.leading_edge_areas,
                          critical.trailing_edge_areas,
                          stress_cell(critical, &FieldPeak::vibration),
                          stress_cell(critical, &FieldPeak::spin),
                          stress_cell(critical, &FieldPeak::both),
                          critical.stress ? critical.stress->part : std::string(),
                          critical.stress ? Cell(critical.stress->place[0] * mm_per_m) : Cell(std::string()),
                          motion_text(critical.motion, critical.period_revolutions),
                          yes_or_no(critical.by_equation_2),
                          yes_or_no(critical.by_aliasing)});
  }
  return table;
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
  std::stable_sort(table.rows.begin(), table.rows.end(), [](const auto& a, const auto& b) {
    return std::get<double>(a.front()) < std::get<double>(b.front());
  });
  return table;
}

Table speed_record(const Study& study) {
  Table table{{"speed [rpm]",
               "amplitude [mm]",
               "motion",
               "revolutions",
               "recorded",
               "change",
               "change rate",
               "energy closing error",
               "steps per revolution",
               "step ratio",
               "contact steps",
               "tension steps",
               "fallbacks",
               "largest penetration [mm]",
               "smallest multiplier [N]",
               "leftover steps",
               "pulling share of force",
               "half the step changes",
               "symmetry",
               "growth left out",
               "from rest differs",
               "off the engine orders [%]",
               "areas LE",
               "areas TE",
               "contrast LE",
               "contrast TE",
               "failure"},
              {}};
  for (std::size_t i = 0; i < study.response.speeds.size(); ++i) {
    const SpeedResponse& at = study.response.speeds[i];
    const auto k = static_cast<Eigen::Index>(i);
    table.rows.push_back({at.speed * rpm_per_rad_s,
                          study.amplitudes.largest[k] * mm_per_m,
                          motion_text(at.motion, at.period_revolutions),
                          at.revolutions,
                          at.recorded_revolutions,
                          at.change,
                          at.change_rate,
                          at.energy.closing_error,
                          at.steps_per_revolution,
                          at.step_ratio,
                          static_cast<double>(at.contact_steps),
                          static_cast<double>(at.tension_steps),
                          static_cast<double>(at.solver_fallbacks),
                          at.largest_penetration * mm_per_m,
                          at.smallest_multiplier,
                          static_cast<double>(at.audit.leftover_steps),
                          at.audit.tension_share,
                          cell(at.audit.halving_difference),
                          symmetry_text(at.audit.symmetry),
                          cell(at.audit.excluded_growth),
                          cell(at.audit.rest_difference),
                          percent * subharmonic_share(study.map.columns[i].spectrum),
                          study.leading_edge.clusters[k],
                          study.trailing_edge.clusters[k],
                          study.leading_edge.contrast[k],
                          study.trailing_edge.contrast[k],
                          std::string()});
  }
  for (const SpeedResponse& at : study.failed) {
    std::vector<Cell> row(table.header.size(), std::string());
    row.front() = at.speed * rpm_per_rad_s;
    row.back() = at.failure;
    table.rows.push_back(std::move(row));
  }
  std::stable_sort(table.rows.begin(), table.rows.end(), [](const auto& a, const auto& b) {
    return std::get<double>(a.front()) < std::get<double>(b.front());
  });
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
