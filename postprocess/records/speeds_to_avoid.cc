// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/speeds_to_avoid.h"

#include <algorithm>
#include <array>

#include "postprocess/records/error_budget_record.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

/// [1] What the error budget of each critical speed leaves open of its speed; 0 without a budget.
std::vector<double> open_shifts(const Study& study, const FieldResults& fields) {
  std::vector<double> shifts(study.critical.size(), 0.0);
  for (const ErrorBudget& budget : error_budgets(study, fields))
    shifts[static_cast<std::size_t>(budget.critical - study.critical.data())] = sum_of(budget).shift;
  return shifts;
}

AvoidedBand widened(const SpeedRange& range, Concern concern, double widening) {
  return {{range.low * (1 - widening), range.high * (1 + widening)}, concern, range, widening};
}

/// Takes in a band that does not begin before this one.
void join(AvoidedBand& band, const AvoidedBand& next) {
  band.speeds.high = std::max(band.speeds.high, next.speeds.high);
  band.widening = std::max(band.widening, next.widening);
  if (next.concern == band.concern)
    band.computed = {std::min(band.computed.low, next.computed.low),
                     std::max(band.computed.high, next.computed.high)};
  if (next.concern <= band.concern) return;
  band.concern = next.concern;
  band.computed = next.computed;
}

std::vector<AvoidedBand> merged(std::vector<AvoidedBand> bands) {
  std::ranges::sort(bands, {}, [](const AvoidedBand& band) { return band.speeds.low; });
  std::vector<AvoidedBand> all;
  for (const AvoidedBand& band : bands)
    if (!all.empty() && band.speeds.low <= all.back().speeds.high)
      join(all.back(), band);
    else
      all.push_back(band);
  return all;
}

/// The speeds around one at which something holds, to the nearest ones at which it does not.
template <class Holds>
SpeedRange around(const Study& study, Eigen::Index index, const Holds& holds) {
  const Eigen::Index last = study.amplitudes.largest.size() - 1;
  Eigen::Index low = index, high = index;
  while (low > 0 && (low == index || holds(low))) --low;
  while (high < last && (high == index || holds(high))) ++high;
  return {study.speed_at(low).speed, study.speed_at(high).speed};
}

void add_stressed(const Study& study, const FieldResults& fields, const std::vector<double>& shifts, double limit,
                  Concern concern, std::vector<AvoidedBand>& all) {
  for (std::size_t i = 0; i < study.critical.size(); ++i) {
    const std::optional<FieldPeak>& stress = fields.peaks[i];
    if (!stress || !stress->cycle || stress->cycle->goodman.value_or(0) <= limit) continue;
    const CriticalSpeed& peak = study.critical[i];
    const double least = limit / *stress->cycle->goodman * peak.amplitude;
    const SpeedRange range =
        around(study, peak.index, [&](Eigen::Index k) { return study.amplitudes.largest[k] > least; });
    all.push_back(
        widened({std::min(range.low, peak.speed_low), std::max(range.high, peak.speed_high)}, concern, shifts[i]));
  }
}

void add_beyond_clearance(const Study& study, const std::vector<double>& shifts, std::vector<AvoidedBand>& all) {
  const auto beyond = [&](Eigen::Index k) {
    return study.amplitudes.largest[k] > study.speed_at(k).clearance[study.amplitudes.node[k]];
  };
  for (Eigen::Index k = 0; k < study.amplitudes.largest.size(); ++k) {
    if (!beyond(k)) continue;
    const SpeedRange range = around(study, k, beyond);
    double widening = 0;
    for (std::size_t i = 0; i < study.critical.size(); ++i)
      if (const double peak = study.critical[i].speed; range.low <= peak && peak <= range.high)
        widening = std::max(widening, shifts[i]);
    all.push_back(widened(range, Concern::beyond_clearance, widening));
  }
}

}  // namespace

const char* name_of(Concern concern) {
  constexpr std::array names = {"tip moves beyond the clearance", "Goodman above 0.5", "Goodman above 1"};
  return names[static_cast<std::size_t>(concern)];
}

std::vector<AvoidedBand> speeds_to_avoid(const Study& study, const FieldResults& fields) {
  const std::vector<double> shifts = open_shifts(study, fields);
  std::vector<AvoidedBand> all;
  add_stressed(study, fields, shifts, 1.0, Concern::above_limit, all);
  add_stressed(study, fields, shifts, 0.5, Concern::above_half, all);
  add_beyond_clearance(study, shifts, all);
  return merged(std::move(all));
}

std::string reason_of(const AvoidedBand& band) {
  std::string text = name_of(band.concern);
  if (band.computed.low > band.speeds.low || band.computed.high < band.speeds.high)
    text += " from " + fixed(band.computed.low * rpm_per_rad_s, 0) + " to " + rpm_text(band.computed.high);
  return text + (band.widening > 0
                     ? ", with " + significant(percent * band.widening, 2) + " % at each end by the error budget"
                     : ", not widened without an error budget");
}

std::string bands_in_words(const std::vector<AvoidedBand>& bands, const FieldResults& fields) {
  std::string text;
  for (const AvoidedBand& band : bands)
    text += (text.empty() ? "" : "; ") + fixed(band.speeds.low * rpm_per_rad_s, 0) + " to " +
            rpm_text(band.speeds.high) + " (" + reason_of(band) + ")";
  if (text.empty()) text = "No speed at which a tip moves beyond the clearance";
  const bool rated = std::any_of(fields.peaks.begin(), fields.peaks.end(),
                                 [](const auto& peak) { return peak && peak->cycle && peak->cycle->goodman; });
  return text + (rated ? "." : "; Goodman's utilisation is not known without --fields and [material].");
}

}  // namespace tiprub::postprocess
