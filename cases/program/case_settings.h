// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <string>

namespace tiprub {

/// Puts one "TABLE.KEY=VALUE" of the command line into a case: the key takes the place of the file's own or joins it,
/// and a table that is not there is made. Raises InputError if it is not of this form or VALUE is no TOML value.
void apply_setting(toml::table& values, const std::string& setting);

/// "--set mesh.element="hex27"": what a message names in place of a file, and what provenance tells.
std::string setting_origin(const std::string& setting);

/// The beginning of a message about a place in the case: "case.toml:3:7: ", or "--set mesh.element="hex27": ".
std::string place(const std::string& file, const toml::source_region& source);

}  // namespace tiprub
