// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/effects/field_effects.h"

#include <cstdlib>

#include "postprocess/effects/coriolis.h"
#include "postprocess/effects/second_order_gap.h"

namespace tiprub {

FieldEffects field_effects(const std::filesystem::path& fields_file, const Study& study) {
  if (fields_file.empty()) return {};
  const FieldsReader reader(fields_file);
  FieldEffects effects{.tip_span = tip_spans(reader.sector())};
  const CoriolisTerms terms(reader, study.model);
  for (const CriticalSpeed& critical : study.critical) {
    const int n = std::abs(critical.rising.signed_nodal_diameter), family = critical.rising.family;
    const double change = terms.change(n, family, critical.speed);
    if (!effects.coriolis || change > effects.coriolis->change)
      effects.coriolis = {change, critical.speed, n, family};
  }
  return effects;
}

}  // namespace tiprub
