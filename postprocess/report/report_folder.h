// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "cases/program/progress.h"
#include "postprocess/report/page.h"

namespace tiprub {

/// All that a report holds.
struct ReportContents {
  Study study;
  ReportSource source;
  std::optional<FieldStudy> fields{};  ///< if fields.h5 was given
  FieldResults field_results{};
  std::vector<SceneNeed> needs{};
  std::vector<Figure> figures{};
};

/// Writes the page, the tables, the figures, and with full fields the files for ParaView; see the README. Raises
/// RunError if a file can't be written.
void write_report_folder(const ReportContents& contents, const std::filesystem::path& folder, Progress::Shown shown);

}  // namespace tiprub
