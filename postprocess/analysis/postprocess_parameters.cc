// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/postprocess_parameters.h"

#include <array>

#include "cases/program/text.h"

namespace tiprub::postprocess {

PostprocessParameters read_postprocess_parameters(CaseTable& table) {
  PostprocessParameters p;
  p.component = table.choice("component", p.component,
                             {{Component::normal, "normal"},
                              {Component::radial, "radial"},
                              {Component::tangential, "tangential"},
                              {Component::axial, "axial"}});
  p.edge = table.choice("edge", p.edge, {{TipEdge::leading, "leading"}, {TipEdge::trailing, "trailing"}});
  p.families = table.integer("families", p.families, Range::between(1, 20), "modal families");
  p.engine_order_max =
      table.integer("engine_order_max", p.engine_order_max, Range::between(1, 100), "multiples of the rotation");
  p.prominence = table.number("prominence", p.prominence, Range::between(0, 1), "of the peak's amplitude");
  p.prediction_tolerance =
      table.number("prediction_tolerance", p.prediction_tolerance, Range::between(0, 1), "of the speed");
  p.amplitude_decades = table.number("amplitude_decades", p.amplitude_decades, Range::between(0.5, 12), "decades");
  p.amplitude_max_mm =
      table.number("amplitude_max_mm", p.amplitude_max_mm, Range::at_least(0), "mm, 0: the largest amplitude");
  if (constexpr double least = 1e-6; p.amplitude_max_mm > 0 && p.amplitude_max_mm < least)
    table.reject("amplitude_max_mm", text_of("= ", p.amplitude_max_mm, " must be at least ", least, " mm, or 0"));
  p.shown_speed_rpm = table.number("shown_speed_rpm", p.shown_speed_rpm, Range::at_least(0),
                                   "rpm, 0: the largest amplitude that repeats at every lobe");
  p.operating_min_rpm = table.number("operating_min_rpm", p.operating_min_rpm, Range::at_least(0), "rpm");
  p.operating_max_rpm = table.number("operating_max_rpm", p.operating_max_rpm, Range::at_least(0),
                                     "rpm, 0: no operating range is given");
  if (p.operating_min_rpm > p.operating_max_rpm)
    table.reject(table.has("operating_max_rpm") ? "operating_max_rpm" : "operating_min_rpm",
                 "leaves no range: operating_max_rpm must be at least operating_min_rpm");
  p.operating_amplitude_mm =
      table.number("operating_amplitude_mm", p.operating_amplitude_mm, Range::at_least(0), "mm, that count");
  p.response_up = table.text("response_up", p.response_up);
  p.response_down = table.text("response_down", p.response_down);
  p.tip_patch_mm =
      table.number("tip_patch_mm", p.tip_patch_mm, Range::at_least(0), "mm, 0: 5 % of the tip line's length");
  p.wear_coefficient = table.number("wear_coefficient", p.wear_coefficient, Range::at_least(0),
                                    "m^2/N, k/H of casing against tip, 0: wear isn't estimated");
  table.close();
  return p;
}

const char* name_of(Component component) {
  constexpr std::array names = {"displacement along the casing normal", "radial displacement",
                                "tangential displacement", "axial displacement"};
  return names[static_cast<std::size_t>(component)];
}

const char* name_of(TipEdge edge) {
  return edge == TipEdge::leading ? "leading edge" : "trailing edge";
}

TipEdge other_than(TipEdge edge) {
  return edge == TipEdge::leading ? TipEdge::trailing : TipEdge::leading;
}

namespace {

/// A strength in MPa would make every margin nonsense.
void check_usual(const CaseTable& table, const MaterialStrength& strength) {
  const Range usual = Range::between(1e6, 1e11);
  require_usual(table, "ultimate_strength", strength.ultimate, usual, "Pa");
  require_usual(table, "endurance_limit", strength.endurance, usual, "Pa");
  if (strength.yield) require_usual(table, "yield_strength", *strength.yield, usual, "Pa");
}

}  // namespace

MaterialStrength read_strength(CaseTable& table) {
  MaterialStrength strength;
  strength.ultimate = table.number("ultimate_strength", std::nullopt, Range::positive(), "Pa");
  strength.endurance = table.number("endurance_limit", std::nullopt, Range::positive(), "Pa, fully reversed");
  const double yield = table.number("yield_strength", 0.0, Range::at_least(0), "Pa, 0: not given");
  if (yield > 0) strength.yield = yield;
  if (strength.endurance >= strength.ultimate)
    table.reject("endurance_limit", "must be below ultimate_strength; are the two exchanged?");
  if (yield > strength.ultimate) table.reject("yield_strength", "must not exceed ultimate_strength");
  if (!table.flag("unusual", false)) check_usual(table, strength);
  table.close();
  return strength;
}

std::optional<MaterialStrength> read_material_strength(const CaseFile& file) {
  if (!file.has("material")) return std::nullopt;
  CaseTable table = file.table("material");
  return read_strength(table);
}

}  // namespace tiprub::postprocess
