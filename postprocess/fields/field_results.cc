// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_results.h"

#include <algorithm>

namespace tiprub {

namespace {

std::string scope_of(const std::optional<FieldStudy>& fields) {
  const std::string what = "displacement and stress on the whole wheel: ";
  if (!fields) return what + "left out, no fields.h5 was given (--fields)";
  const auto is_cycle = [](const FieldPeak& peak) { return peak.cycle.has_value(); };
  if (std::any_of(fields->peaks.begin(), fields->peaks.end(), is_cycle))
    return what + "over all recorded samples of the critical speeds, by linear elasticity";
  return what + (fields->has_instant ? "at the sample with the largest contact force, by linear elasticity; the "
                                       "response holds no whole cycle"
                                     : "modes only, the response holds no state of the rotor; simulate it again");
}

}  // namespace

bool FieldResults::has_stress() const {
  return std::any_of(peaks.begin(), peaks.end(), [](const auto& peak) { return peak.has_value(); });
}

bool FieldResults::has_cycles() const {
  return std::any_of(peaks.begin(), peaks.end(), [](const auto& peak) { return peak && peak->cycle; });
}

FieldResults field_results(const std::optional<FieldStudy>& fields, const std::vector<CriticalSpeed>& critical) {
  FieldResults results{scope_of(fields), std::vector<std::optional<FieldPeak>>(critical.size())};
  if (!fields) return results;
  results.tip_patch = fields->zones.tip_patch;
  results.clamp_rim = fields->zones.clamp_rim;
  for (std::size_t i = 0; i < critical.size(); ++i)
    for (const FieldPeak& peak : fields->peaks)
      if (peak.speed == critical[i].speed) results.peaks[i] = peak;
  return results;
}

}  // namespace tiprub
