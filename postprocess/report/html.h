// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "postprocess/tables/table.h"

namespace tiprub::html {

/// Text with the letters that HTML would read as its own replaced.
std::string escaped(const std::string& text);

/// Base 64 (RFC 4648), for data URIs.
std::string base64(const std::string& bytes);

/// A table with a head; numbers to the right, texts to the left.
std::string table(const Table& table);

/// The page's look and its two scripts' worth of behaviour; no outside resource.
const char* style();
const char* script();

}  // namespace tiprub::html
