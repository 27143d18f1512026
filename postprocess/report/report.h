// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/compare/comparison.h"
#include "postprocess/fields/field_study.h"
#include "postprocess/figures/drawing.h"
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

/// When, from what and in how much time a report was made. This is the only part of a report that differs between
/// runs with the same inputs.
class RunRecord {
 public:
  /// `stages`: files that the stages before wrote with --times. Raises InputError or RunError if one can't be read.
  RunRecord(std::vector<std::filesystem::path> inputs, const std::vector<std::filesystem::path>& stages);

  /// Records the end of a part of the work, which took the time since the last call, and the peak of the memory.
  void done(const std::string& part);
  /// Version and commit, dates of the inputs, times of the stages before and of the parts, the most memory.
  std::vector<Answer> in_words() const;

 private:
  std::vector<std::filesystem::path> inputs_;
  std::string stages_;                                 ///< in words
  std::vector<std::pair<std::string, double>> parts_;  ///< [s]
  double memory_ = 0;                                  ///< [bytes] the most that the process had
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// The content of a report.
struct ReportContents {
  Study study;
  std::string title{};                 ///< of the case
  std::string case_text{};             ///< the case file as it was read
  std::optional<FieldStudy> fields{};  ///< if fields.h5 was given
  FieldResults field_results{};
  std::vector<SceneNeed> needs{};
  std::vector<Figure> figures{};
  ReportNumbers numbers{};              ///< of this report, for later comparisons
  std::vector<ReportNumbers> others{};  ///< to compare with
  RunRecord run{{}, {}};
};

/// The page: page.html with everything filled in. It is self-contained, with styles, scripts, data and the figures,
/// which are read from `folder`/figures; links lead to the tables beside it.
std::string report_page(const ReportContents& contents, const std::filesystem::path& folder);

/// Writes the page, the tables and, with full fields, the files for ParaView beside the figures; see report.md. It
/// waits for `drawing` before it writes the page, which holds the figures. Notes in `contents` how long that took,
/// for the page. Raises RunError if a file can't be written.
void write_report_folder(ReportContents& contents, std::future<void> drawing, const std::filesystem::path& folder);

}  // namespace tiprub::postprocess
