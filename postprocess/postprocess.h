// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "cases/program/command_line.h"

namespace tiprub {

/// The stage: reads the case, the model and the response, computes what is drawn, and writes the folder of the
/// report. Without `fields_file` (empty) fields on the whole wheel are left out. Ends the process with 128 + the
/// signal's number if it is interrupted, after cleaning up. Raises InputError and RunError.
void postprocess(const StageArguments& arguments, const std::filesystem::path& fields_file);

}  // namespace tiprub
