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
#include "postprocess/report/verdict.h"

namespace tiprub::postprocess {

/// Where a report comes from.
struct ReportSource {
  std::string title;      ///< of the case
  std::string case_text;  ///< the case file as it was read
};

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
  ReportSource source;
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
