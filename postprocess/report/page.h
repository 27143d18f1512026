// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/compare/report_numbers.h"
#include "postprocess/fields/field_results.h"
#include "postprocess/figures/figure.h"
#include "postprocess/records/scene_needs_record.h"
#include "postprocess/report/run_record.h"

namespace tiprub {

/// Where a report comes from.
struct ReportSource {
  std::string title;      ///< of the case
  std::string case_text;  ///< the case file as it was read
};

/// All that a report holds.
struct ReportContents {
  Study study;
  ReportSource source;
  std::optional<FieldStudy> fields{};  ///< if fields.h5 was given
  FieldResults field_results{};
  std::vector<SceneNeed> needs{};
  std::vector<Figure> figures{};
  ReportNumbers numbers{};               ///< of this report, for others
  std::optional<ReportNumbers> other{};  ///< to compare with, if one was given
  RunRecord run{{}, {}};
};

/// The page: page.html filled in, styles, scripts and data inside, self-contained: the figures' SVG are read from
/// `folder`/figures, links lead to the tables beside it.
std::string report_page(const ReportContents& contents, const std::filesystem::path& folder);

}  // namespace tiprub
