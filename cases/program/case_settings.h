// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tiprub {

/// Raises InputError at a key or a header with more parts than any case has. The TOML reader takes stack for each
/// part, and has no limit.
void require_short_keys(std::string_view text, const std::string& origin);

/// Puts one "TABLE.KEY=VALUE" of the command line into a case. The key replaces that of the file or is added, and so
/// is its table; without VALUE the key is removed. Raises InputError if the setting is not of this form, VALUE is not
/// TOML, or the key that is to be removed is not there.
void apply_setting(toml::table& values, const std::string& setting);

/// "--set mesh.element="hex27"", which messages name in place of a file, and provenance lists.
std::string setting_origin(const std::string& setting);

/// The beginning of a message about a place in the case: "case.toml:3:7: ", or "--set mesh.element="hex27": ".
std::string place(const std::string& file, const toml::source_region& source);

/// " (did you mean lobes?)", if one of the known words is hardly different; else empty.
std::string meant(std::string_view word, const std::vector<std::string>& known);

/// What a list with this many numbers in a row holds: "[x, y] pairs".
std::string items_of(std::size_t columns);

}  // namespace tiprub
