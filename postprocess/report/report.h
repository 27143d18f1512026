// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/compare/report_numbers.h"
#include "postprocess/fields/field_study.h"
#include "postprocess/figures/drawing.h"
#include "postprocess/records/scene_needs_record.h"
#include "postprocess/report/run_record.h"

namespace tiprub::postprocess {

/// Where a report comes from.
struct ReportSource {
  std::string title;      ///< of the case
  std::string case_text;  ///< the case file as it was read
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
