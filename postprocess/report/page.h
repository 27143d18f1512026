// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_results.h"
#include "postprocess/figures/figure.h"
#include "postprocess/records/scene_needs_record.h"

namespace tiprub {

/// Where a report comes from.
struct ReportSource {
  std::string title;      ///< of the case
  std::string case_text;  ///< the case file as it was read
};

/// The page: page.html filled in, style.css and page.js inside, self-contained: the figures' SVG are read from
/// `folder`/figures, links lead to the tables beside it.
std::string report_page(const Study& study, const FieldResults& fields, const std::vector<SceneNeed>& needs,
                        const ReportSource& source, const std::vector<Figure>& figures,
                        const std::filesystem::path& folder);

}  // namespace tiprub
