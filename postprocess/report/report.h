// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/figures/figure.h"

namespace tiprub {

/// Where a report comes from.
struct ReportSource {
  std::string title;      ///< of the case
  std::string case_text;  ///< the case file as it was read
};

/// The page: self-contained, the figures' SVG inside (read from `folder`/figures), links to the tables beside it.
std::string report_page(const Study& study, const ReportSource& source, const std::vector<Figure>& figures,
                        const std::filesystem::path& folder);

}  // namespace tiprub
