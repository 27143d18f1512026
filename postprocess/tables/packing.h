// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tiprub {

/// Base 64 (RFC 4648, padded, without line breaks): bytes inside text files, as data URIs and VTK's inline arrays
/// want them.
std::string base64(const std::string& bytes);

/// Bytes made smaller, as a browser's DecompressionStream("deflate") reads them (RFC 1950). Same bytes, same result.
std::string deflated(const std::string& bytes);

}  // namespace tiprub
