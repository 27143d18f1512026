// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tiprub {

/// Bytes made smaller, as a browser's DecompressionStream("deflate") reads them (RFC 1950). Same bytes, same result.
std::string deflated(const std::string& bytes);

}  // namespace tiprub
