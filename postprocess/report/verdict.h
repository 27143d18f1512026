// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"
#include "postprocess/records/scene_needs_record.h"
#include "postprocess/records/speeds_to_avoid.h"

namespace tiprub::postprocess {

/// A question that a designer asks first, and its answer in a sentence or two, or in several lines.
struct Answer {
  std::string question;
  std::string text;
};

/// "The speeds are too far apart: ..."; empty if they are not.
std::string speeds_warning(const Study& study);

/// The table of critical speeds as it is printed, below that warning.
std::string printed_critical_speeds(const Study& study, const FieldResults& fields);

/// Whether the speeds are too far apart, how bad the worst speed is, where and why, how far it is from the operating
/// range, which checks passed, and which effects matter although they are left out.
std::vector<Answer> verdict(const Study& study, const FieldResults& fields, const std::vector<SceneNeed>& needs);

/// The margin of the operating range to the nearest critical speeds, and what is known of the range itself; or that
/// the case gives no operating range. `bands`: all speeds to avoid.
std::string margin_text(const Study& study, const FieldResults& fields, const std::vector<AvoidedBand>& bands);

/// The scene in a few words: lobes, clearance, interference, damping, march, speeds.
std::vector<Answer> scene_in_brief(const Study& study);

/// "running clearances 0.120 .. 0.130 mm, given cold": the range over the tip line and the speeds.
std::string running_clearances(const Response& response);

/// Findings beyond the verdict and the tables: what the linear rules missed, how steady the motions are, and what is
/// unusual. Each element is a paragraph.
std::vector<std::string> summary(const Study& study);

}  // namespace tiprub::postprocess
