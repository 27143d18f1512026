// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/speeds_to_avoid.h"

#include <algorithm>
#include <array>

#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

/// Ranges of one concern, joined where they touch.
class Bands {
 public:
  explicit Bands(Concern concern) : concern_(concern) {}

  void add(SpeedRange range) { ranges_.push_back(range); }

  void append_to(std::vector<AvoidedBand>& all) {
    std::sort(ranges_.begin(), ranges_.end(), [](const SpeedRange& a, const SpeedRange& b) { return a.low < b.low; });
    const auto first = static_cast<std::ptrdiff_t>(all.size());
    for (const SpeedRange& range : ranges_) {
      if (std::ssize(all) > first && range.low <= all.back().speeds.high)
        all.back().speeds.high = std::max(all.back().speeds.high, range.high);
      else
        all.push_back({range, concern_});
    }
  }

 private:
  Concern concern_;
  std::vector<SpeedRange> ranges_;
};

/// The speeds around one at which something holds, to the nearest ones at which it does not.
template <class Holds>
SpeedRange around(const Study& study, Eigen::Index index, const Holds& holds) {
  const Eigen::Index last = study.amplitudes.largest.size() - 1;
  Eigen::Index low = index, high = index;
  while (low > 0 && (low == index || holds(low))) --low;
  while (high < last && (high == index || holds(high))) ++high;
  return {study.speed_at(low).speed, study.speed_at(high).speed};
}

void add_stressed(const Study& study, const FieldResults& fields, double limit, Concern concern,
                  std::vector<AvoidedBand>& all) {
  Bands bands(concern);
  for (std::size_t i = 0; i < study.critical.size(); ++i) {
    const std::optional<FieldPeak>& stress = fields.peaks[i];
    if (!stress || !stress->cycle || stress->cycle->goodman.value_or(0) <= limit) continue;
    const CriticalSpeed& peak = study.critical[i];
    const double least = limit / *stress->cycle->goodman * peak.amplitude;
    const SpeedRange range =
        around(study, peak.index, [&](Eigen::Index k) { return study.amplitudes.largest[k] > least; });
    bands.add({std::min(range.low, peak.speed_low), std::max(range.high, peak.speed_high)});
  }
  bands.append_to(all);
}

}  // namespace

const char* name_of(Concern concern) {
  constexpr std::array names = {"tip moves beyond the clearance", "Goodman above 0.5", "Goodman above 1"};
  return names[static_cast<std::size_t>(concern)];
}

std::vector<AvoidedBand> speeds_to_avoid(const Study& study, const FieldResults& fields) {
  std::vector<AvoidedBand> all;
  add_stressed(study, fields, 1.0, Concern::above_limit, all);
  add_stressed(study, fields, 0.5, Concern::above_half, all);
  const auto beyond = [&](Eigen::Index k) {
    return study.amplitudes.largest[k] > study.speed_at(k).clearance[study.amplitudes.node[k]];
  };
  Bands bands(Concern::beyond_clearance);
  for (Eigen::Index k = 0; k < study.amplitudes.largest.size(); ++k)
    if (beyond(k)) bands.add(around(study, k, beyond));
  bands.append_to(all);
  return all;
}

std::string bands_in_words(const std::vector<AvoidedBand>& bands, const FieldResults& fields) {
  std::string text;
  for (const AvoidedBand& band : bands)
    text += (text.empty() ? "" : "; ") + fixed(band.speeds.low * rpm_per_rad_s, 0) + " to " +
            rpm_text(band.speeds.high) + " (" + name_of(band.concern) + ")";
  if (text.empty()) text = "No speed at which a tip moves beyond the clearance";
  const bool rated = std::any_of(fields.peaks.begin(), fields.peaks.end(),
                                 [](const auto& peak) { return peak && peak->cycle && peak->cycle->goodman; });
  return text + (rated ? "." : "; Goodman's utilisation is not known without --fields and [material].");
}

}  // namespace tiprub::postprocess
