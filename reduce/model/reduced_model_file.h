// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "reduce/model/reduced_model.h"

namespace tiprub {

/// model.h5, schema "tiprub-model" version 1; the format is described in reduce/format.md.
void write_model(const ReducedModel& model, const std::filesystem::path& path, const std::string& generator);

/// Raises RunError if the file is missing, damaged, of another schema, or holds a model that can't be one (see
/// check()).
ReducedModel read_model(const std::filesystem::path& path);

}  // namespace tiprub
