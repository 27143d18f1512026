// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tiprub {

/// What is wrong with a text, and where: ":3:7: not TOML: ...".
using TextFault = std::optional<std::string>;

/// Of a text that is no UTF-8.
TextFault fault_of_letters(std::string_view text);

/// Of a text with a key or a header of more parts than any case has: the TOML reader takes stack for each of them,
/// and has no limit.
TextFault fault_of_keys(std::string_view text);

}  // namespace tiprub
