// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/case_file.h"
#include "cases/program/command_line.h"

namespace tiprub::postprocess {

/// The tables of the case that are read, with all keys: the title, [postprocess], [material].
std::string postprocess_tables(const CaseFile& file);

/// Optional inputs; each may be empty.
struct PostprocessOptions {
  std::filesystem::path fields_file;            ///< empty: fields on the whole wheel are left out
  std::filesystem::path budget_fields;          ///< of the model that error budgets compare with; may be empty
  std::vector<std::filesystem::path> compared;  ///< folders of other reports, or other responses of the same model
  std::vector<std::filesystem::path> runs;      ///< notes of the stages before (--times)
};

/// Runs the stage: reads case, model and response, computes the study, and writes the report's folder. If a signal
/// interrupts it, it cleans up and ends the process with 128 + the signal's number. Raises InputError and RunError.
void run_postprocess(const StageArguments& arguments, const PostprocessOptions& options);

}  // namespace tiprub::postprocess
