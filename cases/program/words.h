// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tiprub {

/// "length, count, open"
std::string joined(const std::vector<std::string>& words);

/// " (did you mean lobes?)", if one of the known words is hardly different; else empty.
std::string meant(std::string_view word, const std::vector<std::string>& known);

/// What a list with this many numbers in a row holds: "[x, y] pairs".
std::string items_of(std::size_t columns);

}  // namespace tiprub
