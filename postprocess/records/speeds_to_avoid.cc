// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/speeds_to_avoid.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "postprocess/records/error_budget_record.h"
#include "postprocess/records/study_records.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

/// What the error budget of each critical speed leaves open; nothing without a budget.
std::vector<BudgetSum> open_changes(const Study& study, const FieldResults& fields) {
  std::vector<BudgetSum> changes(study.critical.size());
  for (const ErrorBudget& budget : followed_peaks(study, fields))
    changes[static_cast<std::size_t>(budget.critical - study.critical.data())] = sum_of(budget);
  return changes;
}

AvoidedBand widened(const SpeedRange& range, Concern concern, double widening) {
  return {{range.low * (1 - widening), range.high * (1 + widening)}, concern, widening};
}

/// Bands of one concern, ascending; those that overlap are one.
std::vector<AvoidedBand> joined(std::vector<AvoidedBand> bands) {
  std::ranges::sort(bands, {}, [](const AvoidedBand& band) { return band.speeds.low; });
  std::vector<AvoidedBand> all;
  for (const AvoidedBand& band : bands) {
    if (all.empty() || band.speeds.low > all.back().speeds.high) {
      all.push_back(band);
      continue;
    }
    all.back().speeds.high = std::max(all.back().speeds.high, band.speeds.high);
    all.back().widening = std::max(all.back().widening, band.widening);
  }
  return all;
}

/// What is left of a band outside others, which are ascending and do not overlap.
void add_outside(AvoidedBand band, const std::vector<AvoidedBand>& others, std::vector<AvoidedBand>& all) {
  const bool is_point = band.speeds.low == band.speeds.high;  // where a single speed was computed
  for (const AvoidedBand& other : others) {
    if (is_point && other.speeds.low <= band.speeds.low && band.speeds.low <= other.speeds.high) return;
    if (other.speeds.high <= band.speeds.low || other.speeds.low >= band.speeds.high) continue;
    if (band.speeds.low < other.speeds.low) {
      all.push_back(band);
      all.back().speeds.high = other.speeds.low;
    }
    band.speeds.low = other.speeds.high;
  }
  if (is_point || band.speeds.low < band.speeds.high) all.push_back(band);
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

/// Bands round the speeds at which something holds. A critical speed inside a band is inside with its interval and
/// with what its error budget leaves open.
template <class Holds>
std::vector<AvoidedBand> bands_where(const Study& study, const std::vector<BudgetSum>& changes, Concern concern,
                                     const Holds& holds) {
  std::vector<AvoidedBand> bands;
  for (Eigen::Index k = 0; k < study.amplitudes.largest.size(); ++k) {
    if (!holds(k)) continue;
    SpeedRange range = around(study, k, holds);
    double widening = 0;
    for (std::size_t i = 0; i < study.critical.size(); ++i) {
      const CriticalSpeed& peak = study.critical[i];
      if (!holds(peak.index) || peak.speed < range.low || peak.speed > range.high) continue;
      range = {std::min(range.low, peak.speed_low), std::max(range.high, peak.speed_high)};
      widening = std::max(widening, changes[i].shift);
    }
    bands.push_back(widened(range, concern, widening));
  }
  return bands;
}

/// The critical speeds below the limit whose error budget leaves a utilisation above it open. The peak that reaches
/// it may be another one, so that no more is known of its width than where it lies.
std::vector<AvoidedBand> perhaps_stressed(const Study& study, const std::vector<BudgetSum>& changes,
                                          const Eigen::VectorXd& utilisation, double limit) {
  std::vector<AvoidedBand> bands;
  if (utilisation.size() == 0) return bands;
  for (std::size_t i = 0; i < study.critical.size(); ++i)
    if (const double here = utilisation[study.critical[i].index];
        here <= limit && here * (1 + changes[i].stress_rise) > limit)
      bands.push_back(widened({study.critical[i].speed_low, study.critical[i].speed_high},
                              Concern::perhaps_above_limit, changes[i].shift));
  return bands;
}

std::vector<AvoidedBand> beyond_clearance(const Study& study, const std::vector<BudgetSum>& changes) {
  const TipAmplitudes normal = tip_amplitudes(study.response, study.model.contact, Component::normal);
  return bands_where(study, changes, Concern::beyond_clearance, [&](Eigen::Index k) {
    return (normal.by_node.col(k) - study.speed_at(k).clearance).maxCoeff() > 0;
  });
}

std::vector<AvoidedBand> stressed(const Study& study, const std::vector<BudgetSum>& changes,
                                  const Eigen::VectorXd& utilisation, double limit, Concern concern) {
  if (utilisation.size() == 0) return {};
  return bands_where(study, changes, concern, [&](Eigen::Index k) { return utilisation[k] > limit; });
}

std::string widening_text(double widening) {
  return widening > 0 ? significant(percent * widening, 2) + " % at each end by the error budget"
                      : "not widened without an error budget";
}

/// "27000 and 30000 rpm", or "6 speeds between 18750 and 23000 rpm"; ascending speeds [rad/s].
std::string speeds_text(const std::vector<double>& speeds) {
  if (speeds.size() == 1) return rpm_text(speeds.front());
  const std::string first = fixed(speeds.front() * rpm_per_rad_s, 0), last = rpm_text(speeds.back());
  return speeds.size() == 2 ? first + " and " + last
                            : std::to_string(speeds.size()) + " speeds between " + first + " and " + last;
}

std::string range_text(const SpeedRange& range) {
  return fixed(range.low * rpm_per_rad_s, 0) + " to " + rpm_text(range.high);
}

/// "; Goodman's utilisation is not known without ...", "; estimated, because the response holds one instant of its
/// motion: 21303 rpm"; empty if all critical speeds are rated.
std::string not_rated(const FieldResults& fields) {
  if (fields.worst_cycle() == nullptr && fields.utilisation.size() == 0)
    return std::string("; Goodman's utilisation is not known without ") +
           (fields.has_stress() || fields.over_speed.size() > 0
                ? "endurance_limit and ultimate_strength in [material]"
                : "--fields");
  if (fields.worst_cycle() == nullptr)
    return std::string(
               "; utilisations are estimated, because the response holds no whole cycle of a critical speed") +
           (fields.peaks.empty() ? "" : " (simulate.examine = \"critical_speeds\")");
  std::vector<double> speeds;
  for (const std::optional<FieldPeak>& peak : fields.peaks)
    if (peak && !peak->cycle) speeds.push_back(peak->speed);
  return speeds.empty()
             ? ""
             : "; estimated, because the response holds a single instant of the motion: " + speeds_text(speeds);
}

/// "Goodman above 0.5; Goodman above 1 from 18604 to 21188 rpm and from ..."; without speeds if it is one band.
std::string concerns_of(const std::vector<AvoidedBand>& touching) {
  std::string text;
  for (int grade = 0; grade < concerns; ++grade) {
    const auto concern = static_cast<Concern>(grade);
    const std::string speeds = listed(touching, " and", [&](const AvoidedBand& band) {
      return band.concern == concern ? " from " + range_text(band.speeds) : "";
    });
    if (speeds.empty()) continue;
    text += (text.empty() ? "" : "; ") + std::string(name_of(concern)) + (touching.size() > 1 ? speeds : "");
  }
  return text;
}

}  // namespace

const char* name_of(Concern concern) {
  constexpr std::array<const char*, concerns> names = {"tip moves beyond the clearance", "Goodman above 0.5",
                                                       "Goodman perhaps above 1", "Goodman above 1"};
  return names[static_cast<std::size_t>(concern)];
}

std::vector<AvoidedBand> speeds_to_avoid(const Study& study, const FieldResults& fields) {
  const std::vector<BudgetSum> changes = open_changes(study, fields);
  const Eigen::VectorXd utilisation = utilisation_over_speed(study, fields);
  const std::array<std::vector<AvoidedBand>, concerns> by_gravity = {
      stressed(study, changes, utilisation, 1.0, Concern::above_limit),
      perhaps_stressed(study, changes, utilisation, 1.0),
      stressed(study, changes, utilisation, 0.5, Concern::above_half), beyond_clearance(study, changes)};
  std::vector<AvoidedBand> all;
  for (const std::vector<AvoidedBand>& bands : by_gravity) {
    const std::vector<AvoidedBand> graver = all;
    for (const AvoidedBand& band : joined(bands)) add_outside(band, graver, all);
    std::ranges::sort(all, {}, [](const AvoidedBand& band) { return band.speeds.low; });
  }
  return all;
}

std::string reason_of(const AvoidedBand& band) {
  return std::string(name_of(band.concern)) + ", " + widening_text(band.widening);
}

std::string bands_in_words(const std::vector<AvoidedBand>& bands, const FieldResults& fields) {
  std::string text;
  for (auto first = bands.begin(); first != bands.end();) {
    auto last = first;
    double widening = first->widening;
    while (std::next(last) != bands.end() && std::next(last)->speeds.low <= last->speeds.high)
      widening = std::max(widening, (++last)->widening);
    const std::vector<AvoidedBand> touching(first, std::next(last));
    text += (text.empty() ? "" : "; ") + range_text({first->speeds.low, last->speeds.high}) + " (" +
            concerns_of(touching) + "; " + widening_text(widening) + ")";
    first = std::next(last);
  }
  if (text.empty()) text = "No speed at which a tip moves beyond the clearance";
  return text + not_rated(fields) + ".";
}

std::string unknown_speeds(const Study& study) {
  std::vector<double> failed, unstable;
  for (const SpeedResponse& speed : study.failed) failed.push_back(speed.speed);
  for (const SpeedResponse& speed : study.response.speeds)
    if (speed.audit.symmetry == SymmetryVerdict::breaking && whole_wheel(speed) == nullptr)
      unstable.push_back(speed.speed);
  std::string text;
  if (!failed.empty()) text += " Not computed, because the march failed: " + speeds_text(failed) + ".";
  if (!unstable.empty())
    text += " Blades may move farther where the symmetric motion is unstable: at " + speeds_text(unstable) + ".";
  return text;
}

}  // namespace tiprub::postprocess
