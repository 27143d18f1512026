// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "simulate/response.h"

namespace tiprub {

/// response.h5, schema "tiprub-response" version 1; the format is described in simulate/README.md.
void write_response(const Response& response, const std::filesystem::path& path, const std::string& generator);

/// Raises RunError if the file is missing, damaged, of another schema, or its arrays don't fit together.
Response read_response(const std::filesystem::path& path);

}  // namespace tiprub
