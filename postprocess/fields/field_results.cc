// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_results.h"

#include <algorithm>

namespace tiprub {

namespace {

std::string scope_of(const std::optional<FieldStudy>& fields) {
  const std::string what = "displacement and stress on the whole wheel: ";
  if (!fields) return what + "left out, no fields.h5 was given (--fields)";
  return what + (fields->has_instant ? "at the sample with the largest contact force, by linear elasticity"
                                     : "modes only, the response holds no state of the rotor; simulate it again");
}

}  // namespace

bool FieldResults::has_stress() const {
  return std::any_of(peaks.begin(), peaks.end(), [](const auto& peak) { return peak.has_value(); });
}

FieldResults field_results(const std::optional<FieldStudy>& fields, const std::vector<CriticalSpeed>& critical) {
  FieldResults results{scope_of(fields), std::vector<std::optional<FieldPeak>>(critical.size())};
  if (!fields) return results;
  for (std::size_t i = 0; i < critical.size(); ++i)
    for (const FieldPeak& peak : fields->peaks)
      if (peak.speed == critical[i].speed) results.peaks[i] = peak;
  return results;
}

}  // namespace tiprub
