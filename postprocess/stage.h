// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"

namespace tiprub {

/// What is read of the case: the title, [postprocess], [material].
std::string postprocess_tables(const CaseFile& file);

/// What else may be given; each may be empty.
struct PostprocessOptions {
  std::filesystem::path fields_file;        ///< empty: fields on the whole wheel are left out
  std::filesystem::path compared;           ///< another report's folder, or another response of the same model
  std::vector<std::filesystem::path> runs;  ///< how long the stages before took, as they noted it
};

/// The stage: reads the case, the model and the response, computes what is drawn, and writes the folder of the
/// report. Ends the process with 128 + the signal's number if it is interrupted, after cleaning up. Raises InputError
/// and RunError.
void run_postprocess(const StageArguments& arguments, const PostprocessOptions& options);

}  // namespace tiprub
