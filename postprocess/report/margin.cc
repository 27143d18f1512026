// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/report/report.h"

#include <algorithm>
#include <optional>

#include "postprocess/fields/field_study.h"
#include "postprocess/records/exactness_record.h"
#include "postprocess/tables/table.h"

namespace tiprub::postprocess {

namespace {

/// " Inside it the tip moves towards the casing by up to 0.013 mm.", and what else is known of the range.
std::string inside_text(const Study& study, const SpeedRange& range, const std::vector<AvoidedBand>& bands) {
  const auto holds = [&](double speed) { return range.low <= speed && speed <= range.high; };
  std::optional<double> largest;
  for (std::size_t i = 0; i < study.response.speeds.size(); ++i)
    if (holds(study.response.speeds[i].speed))
      largest = std::max(largest.value_or(0), study.amplitudes.largest[static_cast<Eigen::Index>(i)]);
  std::string text =
      largest ? (study.parameters.component == Component::normal
                     ? std::string(" Inside it the tip moves towards the casing by up to ")
                     : std::string(" Inside it the ") + name_of(study.parameters.component) + " is up to ") +
                    mm_text(*largest) + "."
              : " No speed inside it was simulated.";
  if (largest && (range.low < study.range.low || range.high > study.range.high))
    text += " Not all of the range was simulated.";
  for (const CriticalSpeed& peak : study.not_located)
    if (peak.speed_low <= range.high && range.low <= peak.speed_high)
      text += " A peak of " + mm_text(peak.amplitude) + " that is not located may lie inside it.";
  if (const auto failed = std::ranges::count_if(study.failed, holds, &SpeedResponse::speed); failed > 0)
    text += " " + counted(static_cast<std::size_t>(failed), "speed") + " inside it failed.";
  const std::string avoided = listed(bands, ", ", [&](const AvoidedBand& band) {
    const double low = std::max(band.speeds.low, range.low), high = std::min(band.speeds.high, range.high);
    return low < high ? fixed(low * rpm_per_rad_s, 0) + " .. " + fixed(high * rpm_per_rad_s, 0) : "";
  });
  return avoided.empty() ? text : text + " Speeds to avoid reach into it: " + avoided + " rpm.";
}

/// The critical speeds that move or stress the wheel enough to count.
std::vector<CriticalSpeed> that_count(const Study& study, const FieldResults& fields) {
  const Eigen::VectorXd utilisation = utilisation_over_speed(study, fields);
  std::vector<CriticalSpeed> counted;
  for (const CriticalSpeed& peak : study.critical) {
    const bool breaks = utilisation.size() > 0 && utilisation[peak.index] > 1;
    if (breaks || peak.amplitude >= study.parameters.operating_amplitude_mm / mm_per_m) counted.push_back(peak);
  }
  return counted;
}

}  // namespace

std::string margin_text(const Study& study, const FieldResults& fields, const std::vector<AvoidedBand>& bands) {
  const PostprocessParameters& keys = study.parameters;
  if (!(keys.operating_max_rpm > 0))
    return "Not known: the case gives no operating range ([postprocess] operating_min_rpm, operating_max_rpm).";
  const SpeedRange operating{keys.operating_min_rpm * rad_s_per_rpm, keys.operating_max_rpm * rad_s_per_rpm};
  const OperatingMargin margin = operating_margin(that_count(study, fields), operating);
  std::string text = "Operating range " + fixed(keys.operating_min_rpm, 0) + " to " + rpm_text(operating.high) + ": ";
  const auto rpm = [](const CriticalSpeed& peak) { return fixed(peak.speed * rpm_per_rad_s, 0); };
  text += margin.inside.empty() ? "no critical speed inside"
                                : counted(margin.inside.size(), "critical speed") + " inside (" +
                                      listed(margin.inside, ", ", rpm) + " rpm)";
  const auto outside = [](const std::optional<SpeedMargin>& there, const std::string& which) {
    return there ? "; the next " + which + ", " + rpm_text(there->speed) + ", is " +
                       fixed(percent * there->margin, 1) + " % away"
                 : std::string();
  };
  text += outside(margin.below, "below") + outside(margin.above, "above") + speeds_caveat(study) + ".";
  return text + inside_text(study, operating, bands);
}

}  // namespace tiprub::postprocess
