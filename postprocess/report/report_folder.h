// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "cases/program/progress.h"
#include "postprocess/report/page.h"

namespace tiprub {

/// Writes the page, the tables, the figures, and with full fields the files for ParaView; see the README. Raises
/// RunError if a file can't be written. The page tells how long the pictures took.
void write_report_folder(ReportContents& contents, const std::filesystem::path& folder, Progress::Shown shown);

}  // namespace tiprub
