// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/effects/field_effects.h"

#include <cstdlib>

#include "postprocess/effects/coriolis.h"
#include "postprocess/effects/second_order_gap.h"

namespace tiprub {

FieldEffects field_effects(const std::filesystem::path& fields_file, const ReducedModel& model,
                           const std::vector<CriticalSpeed>& critical) {
  if (fields_file.empty()) return {};
  const FieldsReader reader(fields_file);
  FieldEffects effects{.tip_span = tip_spans(reader.sector())};
  const CoriolisTerms terms(reader, model);
  for (const CriticalSpeed& peak : critical) {
    const int n = std::abs(peak.rising.signed_nodal_diameter), family = peak.rising.family;
    const double change = terms.change(n, family, peak.speed);
    if (!effects.coriolis || change > effects.coriolis->change) effects.coriolis = {change, peak.speed, n, family};
  }
  return effects;
}

}  // namespace tiprub
