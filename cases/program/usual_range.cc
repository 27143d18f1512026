// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/usual_range.h"

#include <sstream>

namespace tiprub {

void require_usual(const CaseTable& table, std::string_view key, double value, const Range& usual,
                   std::string_view unit) {
  if (usual.holds(value)) return;
  std::ostringstream text;
  text << "= " << value << " is unusual: expected " << usual.describe() << " [" << unit
       << "]; is it in another unit? If it is meant, add unusual = true to this table";
  table.reject(key, text.str());
}

}  // namespace tiprub
