// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

namespace tiprub {

/// The keys of a case's text, "mesh.density", with their values as they are written, without comments and blanks. The
/// copy that an output keeps has the keys of the command line behind "# --set ".
std::map<std::string, std::string> written_keys(const std::string& text);

/// The keys of some tables, such as "mesh.", whose values in the case differ from those that a file was made with.
struct DifferingKeys {
  /// For each of them, after a line break: "sector.msh was made with mesh.blade_count = 6, and the case has 8; " and
  /// the consequence.
  std::string lines;
  std::map<std::string, std::string> made_with;  ///< their values in the file
};
DifferingKeys differing_keys(const std::string& file, const std::string& made_with, const std::string& case_text,
                             std::initializer_list<std::string_view> tables, const std::string& consequence);

}  // namespace tiprub
