// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/validity.h"

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

std::string outside_validity(const Study& study, std::size_t critical, const FieldResults& fields) {
  const GapTerms& gap = study.gap[static_cast<std::size_t>(study.critical[critical].index)];
  const std::optional<FieldPeak>& stress = fields.peaks[critical];
  std::string text = gap.beyond() ? gap.in_words() : "";
  if (stress && stress->yield_share.value_or(0) > 1)
    text += (text.empty() ? "" : "; ") + std::string("stress ") + fixed(*stress->yield_share, 2) + " of yield";
  return text;
}

std::string validity_in_short(const Study& study, std::size_t critical, const FieldResults& fields) {
  if (outside_validity(study, critical, fields).empty()) return "inside";
  const GapTerms& gap = study.gap[static_cast<std::size_t>(study.critical[critical].index)];
  return "outside: " + (gap.beyond() ? significant(gap.together * mm_per_m, 2) + " / " +
                                           significant(gap.interference * mm_per_m, 2) + " mm"
                                     : std::string("yield"));
}

}  // namespace tiprub::postprocess
