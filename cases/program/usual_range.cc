// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/usual_range.h"
#include "cases/program/text.h"

namespace tiprub {

void require_usual(const CaseTable& table, std::string_view key, double value, const Range& usual,
                   std::string_view unit) {
  if (usual.holds(value)) return;
  table.reject(key, text_of("= ", value, " is unusual: expected ", usual.describe(), " [", unit,
                            "]; is it in another unit? If it is meant, add unusual = true to this table"));
}

}  // namespace tiprub
