// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/material_strength.h"

namespace tiprub {

MaterialStrength read_strength(CaseTable& table) {
  MaterialStrength strength;
  strength.ultimate = table.number("ultimate_strength", std::nullopt, Range::positive(), "Pa");
  strength.endurance = table.number("endurance_limit", std::nullopt, Range::positive(), "Pa, fully reversed");
  const double yield = table.number("yield_strength", 0.0, Range::at_least(0), "Pa, 0: not given");
  if (yield > 0) strength.yield = yield;
  table.close();
  return strength;
}

std::optional<MaterialStrength> read_material_strength(const CaseFile& file) {
  if (!file.has("material")) return std::nullopt;
  CaseTable table = file.table("material");
  return read_strength(table);
}

double goodman_utilisation(const MaterialStrength& strength, double alternating, double mean) {
  return alternating / strength.endurance + mean / strength.ultimate;
}

}  // namespace tiprub
